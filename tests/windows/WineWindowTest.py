"""The window and the console of the zip for Windows, driven by real keys.

Usage: WineWindowTest.py ZIP [unittest arguments]. ZIP: made by tools/make-windows-zip.
"""

import contextlib
import fcntl
import json
import os
import pty
import queue
import subprocess
import sys
import termios
import threading
import time
import unittest
import urllib.parse

from WineDriver import SECONDS, Wine, png_pixels
from DragSource import DragSource

Wine.zip = sys.argv.pop(1)
VIEW = ["view", "--size", "480x270", "--at", "hill", "--fly"]
LIGHT = 0xFFFFE296  # the light behind the archway of tools/windows/make-icon: alpha, red, green, blue


class Followed:
    """A window that prints the state of each frame."""

    def __init__(self, test, *arguments):
        self.test = test
        self.view = subprocess.Popen(["wine", test.program, *VIEW, "--tell", "--step", "0.0333", *arguments], env=test.env, cwd=test.work,
                                     stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, encoding="utf-8")
        self.states = queue.Queue()
        self.reader = threading.Thread(target=lambda: [self.states.put(json.loads(line)) for line in self.view.stdout], daemon=True)
        self.reader.start()
        self.start = self.until(lambda state: "eye" in state)
        self.window = test.windows()[-1]
        test.xdotool("windowfocus", self.window)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.test.end_wine()
        self.view.wait()
        self.reader.join(10)
        self.view.stdout.close()

    def until(self, holds):
        for _ in range(3000):
            state = self.states.get(timeout=120)
            if holds(state):
                return state
        return self.test.fail("the state did not come")


class Terminal:
    """A program in a console of Wine, which reads and writes a pseudo terminal."""

    def __init__(self, test, *arguments):
        self.test = test
        self.end, terminal = pty.openpty()
        self.program = subprocess.Popen(["wine", *arguments], env=test.env, cwd=test.work, stdin=terminal, stdout=terminal, stderr=terminal,
                                        start_new_session=True, preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        os.close(terminal)
        self.text = bytearray()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        with contextlib.suppress(OSError):  # the terminal's other side is closed
            while part := os.read(self.end, 1 << 16):
                self.text += part

    def type(self, keys):
        os.write(self.end, keys)

    def until(self, holds):
        end = time.monotonic() + 300
        while not holds():
            self.test.assertLess(time.monotonic(), end, bytes(self.text[-2000:]))
            time.sleep(0.1)

    def leave(self):
        """Waits for the program. Returns its exit code and the text on the terminal."""
        code = self.program.wait(timeout=SECONDS)
        self.test.end_wine()
        self.reader.join(10)
        os.close(self.end)
        return code, self.text.decode(errors="replace")


class WineWindow(Wine):
    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.env, capture_output=True, text=True, check=True, timeout=300).stdout

    def windows(self):
        """The visible windows of Limen, at least one."""
        return self.xdotool("search", "--sync", "--onlyvisible", "--name", "Limen").split()

    def test_it_takes_keys_and_keeps_a_picture(self):
        with Followed(self) as view:
            self.xdotool("keydown", "w")
            view.until(lambda state: "eye" in state and sum((a - b) ** 2 for a, b in zip(state["eye"], view.start["eye"])) > 1.0)
            self.xdotool("keyup", "w")
            self.xdotool("key", "F12")
            view.until(lambda _: list(self.work.glob("limen-*.txt")))
            picture, = self.work.glob("limen-*.png")
            self.assertEqual(png_pixels(picture)[:2], (480, 270))
            self.xdotool("key", "Escape")
            view.until(lambda state: state.get("page") == "menu")

    def test_its_icon_is_that_of_the_program(self):
        with Followed(self) as view:
            shown = subprocess.run(["xprop", "-id", view.window, "-notype", "32c", "_NET_WM_ICON"], env=self.env, capture_output=True, text=True,
                                   check=True, timeout=60).stdout
        numbers = [int(number) for number in shown.split("=")[1].replace(",", " ").split()]
        width, height = numbers[:2]
        self.assertEqual((width, height), (32, 32))
        self.assertEqual(numbers[2 + width * (height // 2) + width // 2], LIGHT)

    def test_its_letters_grow_with_the_resolution_of_the_screen(self):
        self.wine("reg", "add", r"HKCU\Control Panel\Desktop", "/v", "LogPixels", "/t", "REG_DWORD", "/d", "144", "/f")
        self.end_wine()
        try:
            with Followed(self) as view:
                self.assertEqual((view.start["ui_scale"], view.start["size"]), (1.5, [480, 270]))
        finally:
            self.wine("reg", "delete", r"HKCU\Control Panel\Desktop", "/v", "LogPixels", "/f")
            self.end_wine()

    def test_it_reads_the_settings_of_a_user_with_an_odd_name(self):
        settings = self.user_directory("Roaming")
        settings.mkdir(exist_ok=True)
        (settings / "settings.json").write_text('{"ui_scale": 1.25}', encoding="utf-8")
        try:
            with Followed(self) as view:
                self.assertEqual(view.start["ui_scale"], 1.25)
        finally:
            (settings / "settings.json").unlink()

    def test_it_opens_a_dropped_directory_with_an_odd_name(self):
        subprocess.run(["wine", self.program, "demo", "Welt für мир"], env=self.env, cwd=self.work, check=True, timeout=SECONDS, capture_output=True)
        world = self.work / "Welt für мир"
        source = DragSource(self.display)
        try:
            with Followed(self) as view:
                self.assertTrue(source.drop(view.window, 200, 150, "file://" + urllib.parse.quote(str(world)) + "\r\n"))
                view.until(lambda state: state["world"] == self.windows_path(world))
        finally:
            source.close()

    def test_without_a_console_a_box_has_the_error(self):
        """As by a double click: nobody reads the program's output."""
        view = subprocess.Popen(["wine", self.program, "view", "--keys", "Tästen да.json"], env=self.env, cwd=self.work, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        box = self.windows()[-1]
        self.assertIsNone(view.poll(), "the box waits for a person")
        messages = (self.user_directory("Local") / "messages.txt").read_text(encoding="utf-8")
        self.assertTrue(messages.startswith("limen: Tästen да.json: cannot be read"), messages)
        self.xdotool("windowfocus", "--sync", box, "key", "Return")
        self.assertEqual(view.wait(timeout=60), 2)

    def test_a_console_shows_letters_of_any_language(self):
        terminal = Terminal(self, self.program, "places", "--dat", "Дверь für alle")
        code, text = terminal.leave()
        self.assertEqual(code, 2)
        self.assertIn("Дверь für alle", text)

    def test_ctrl_c_ends_a_check_with_its_result_so_far(self):
        self.compile("Shell.c", self.work / "shell.exe")
        terminal = Terminal(self, "shell.exe", self.windows_path(self.program.relative_to(self.work))[2:], "check", "--views", "100000", "--size", "64x36")
        terminal.until(lambda: b"/100000" in terminal.text)
        terminal.type(b"\x03")
        code, text = terminal.leave()
        self.assertEqual(code, 130, text[-2000:])
        self.assertIn("limen: stopped after", text)

    def test_ctrl_c_closes_the_window(self):
        self.compile("Shell.c", self.work / "shell.exe")
        terminal = Terminal(self, "shell.exe", self.windows_path(self.program.relative_to(self.work))[2:], *VIEW)
        self.windows()
        terminal.type(b"\x03")
        code, text = terminal.leave()
        self.assertEqual(code, 130, text)
        self.assertIn("limen: ended by Ctrl-C", text)


if __name__ == "__main__":
    unittest.main()
