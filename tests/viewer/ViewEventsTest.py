"""Events of the window: resizing, minimising, other windows, a lost display.

Usage: ViewEventsTest.py PROGRAM CACHE [unittest arguments]
"""

import ctypes
import os
import subprocess
import sys
import time
import unittest

from WindowDriver import Followed, WindowTest, start_server

WindowTest.program = PROGRAM = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)


class Desktop:
    """Performs the tasks of a window manager, because the test's server has none."""

    ICONIC, NORMAL = 3, 1

    def __init__(self, display):
        self.x = ctypes.CDLL("libX11.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XInternAtom.restype = ctypes.c_ulong
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x.XCreateSimpleWindow.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))
        self.root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))

    def atom(self, name):
        return ctypes.c_ulong(self.x.XInternAtom(self.display, name.encode(), 0))

    def set_state(self, window, state):
        kind = self.atom("WM_STATE")
        data = (ctypes.c_ulong * 2)(state, 0)
        self.x.XChangeProperty(self.display, ctypes.c_ulong(int(window)), kind, kind, 32, 0, data, 2)
        (self.x.XUnmapWindow if state == self.ICONIC else self.x.XMapWindow)(self.display, ctypes.c_ulong(int(window)))
        self.x.XSync(self.display, 0)

    def take_keys(self):
        """Opens another window and gives it the keyboard focus."""
        other = ctypes.c_ulong(self.x.XCreateSimpleWindow(self.display, self.root, 700, 500, 50, 50, 0, ctypes.c_ulong(0), ctypes.c_ulong(0)))
        self.x.XMapWindow(self.display, other)
        self.x.XSync(self.display, 0)
        self.x.XSetInputFocus(self.display, other, 1, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def set_resources(self, text):
        self.x.XChangeProperty(self.display, self.root, self.atom("RESOURCE_MANAGER"), self.atom("STRING"), 8, 0, text.encode(), len(text))
        self.x.XSync(self.display, 0)

    def close(self):
        self.x.XCloseDisplay(self.display)


class ViewEvents(WindowTest):
    VIEW = ("--at", "cottage.room", "--yaw", "90", "--pitch", "0")

    def test_it_is_drawn_in_every_size_down_to_a_pixel(self):
        with Followed(self, *self.VIEW, size="320x180") as view:
            for width, height in ((1, 1), (3, 200), (640, 2), (500, 400), (320, 180)):
                self.ask("windowsize", view.window, str(width), str(height))
                view.until(lambda s: s["size"] == [width, height], f"{width}x{height}")
                view.next()
            self.assertEqual(view.leave(), (0, ""))

    def test_as_an_icon_it_rests_and_the_world_stands_still(self):
        desktop = Desktop(self.display)
        with Followed(self, *self.VIEW, size="320x180", step=None) as view:
            before = view.latest()
            desktop.set_state(view.window, Desktop.ICONIC)
            while True:  # frames already in progress
                try:
                    before = view.next(5)
                except Exception:
                    break
            time.sleep(2)
            self.assertTrue(view.lines.empty(), "nothing is drawn")
            self.assertIsNone(view.view.poll())
            desktop.set_state(view.window, Desktop.NORMAL)
            after = view.next()
            self.assertEqual(after["frames"], before["frames"] + 1)
            self.assertLess(after["seconds"] - before["seconds"], 2.0, "time stops while minimised")
            view.latest()
            self.ask("windowfocus", view.window)
            self.assertEqual(view.leave(), (0, ""))
        desktop.close()

    def test_when_another_window_takes_the_keys_all_are_let_go(self):
        with Followed(self, *self.VIEW, size="320x180") as view:
            self.ask("mousemove", "300", "160")
            view.until(lambda s: s["on_ground"], "it stands")
            start = view.state["eye"]
            self.ask("keydown", "w")
            view.until(lambda s: s["eye"] != start, "it walks")
            self.ask("mousedown", "1")
            for _ in range(3):
                self.ask("mousemove_relative", "5", "0")
                view.next()
            desktop = Desktop(self.display)
            desktop.take_keys()  # W is still pressed
            view.latest()
            for _ in range(12):
                view.next()
            still = view.next()
            self.assertEqual(view.next()["eye"], still["eye"], "nobody walks")
            self.ask("mousemove_relative", "40", "0")
            view.latest()
            self.assertEqual(view.next()["yaw"], still["yaw"], "nobody turns")
            self.assertIsNone(view.state["picked"], "a release by focus loss is not a click")
            self.ask("keyup", "w", "mouseup", "1")
            self.ask("windowfocus", view.window)
            start = view.latest()["eye"]
            self.ask("keydown", "s")
            view.until(lambda s: s["eye"] != start, "keys work again")
            self.ask("keyup", "s")
            self.assertEqual(view.leave(), (0, ""))
            desktop.close()

    def test_a_server_that_goes_away_is_said_and_the_walk_is_kept(self):
        # A large window, four times: a program that used it after the loss crashed in about half of the runs.
        for number in range(4):
            self.lose_the_server(f"walk{number}")

    def lose_the_server(self, walk):
        server, display = start_server()
        try:
            with Followed(self, *self.VIEW, "--record", walk, size="1280x720", environment={"DISPLAY": display}, find=False) as view:
                for _ in range(4):  # a frame records a line
                    view.next()
                server.kill()
                server.wait()
                code, errors = view.end()
        finally:
            server.kill()
        self.assertEqual((code, errors), (2, "limen: view: the connection to the display was lost\n"))
        with open(self.path(walk)) as lines:
            self.assertGreater(len(lines.readlines()), 2)

    def test_without_a_display_or_the_gl_it_says_what_is_missing(self):
        for environment, what in (({"DISPLAY": ":987"}, "no display to open a window on"),
                                  ({"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLSL_VERSION_OVERRIDE": "330"},
                                   "OpenGL 4.5 core profile is required and the driver offers 3.3")):
            done = subprocess.run([PROGRAM, "view", "--frames", "1"], env=dict(self.env, **environment), cwd=self.work.name,
                                  capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(what, done.stderr)

    def test_the_panel_grows_with_the_screens_scale(self):
        server, display = start_server()
        desktop = Desktop(display)
        try:
            desktop.set_resources("Xft.dpi:\t192\n")
            with Followed(self, *self.VIEW, size="640x360", environment={"DISPLAY": display}, find=False) as view:
                self.assertEqual(view.next()["ui_scale"], 2.0)
                self.assertEqual(view.state["size"], [640, 360])
        finally:
            desktop.close()
            server.terminate()
            server.wait()
        with Followed(self, *self.VIEW, size="320x180") as view:
            self.assertEqual(view.next()["ui_scale"], 1.0)


if __name__ == "__main__":
    unittest.main()
