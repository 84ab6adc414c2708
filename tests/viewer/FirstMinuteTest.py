"""The first minute in the window: a world without files, the menu, own files, faults, settings, signals.

Usage: FirstMinuteTest.py PROGRAM CACHE [unittest arguments]
"""

import json
import math
import os
import signal
import subprocess
import sys
import unittest
import urllib.parse

from DragSource import DragSource
from WindowDriver import Followed, WindowTest

WindowTest.program = PROGRAM = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)


class FirstMinute(WindowTest):
    SMALL = ("--radius", "1", "--far", "0")

    def open(self, *arguments, **named):
        return Followed(self, *self.SMALL, *arguments, **dict({"size": "640x360"}, **named))

    def demo(self, name):
        """The built-in world's files in a directory of their own."""
        subprocess.run([PROGRAM, "demo", self.path(name)], env=self.env, check=True, capture_output=True)
        return self.path(name)

    def settings(self):
        with open(self.path("config", "limen", "settings.json")) as file:
            return json.load(file)

    def write_settings(self, text):
        os.makedirs(self.path("config", "limen"), exist_ok=True)
        with open(self.path("config", "limen", "settings.json"), "w") as file:
            file.write(text)

    def test_it_begins_outside_by_day_with_hints_for_ten_seconds(self):
        with self.open(step="1.0", world=False, size="320x180") as view:
            self.assertEqual(view.state["page"], "loading")
            self.assertEqual(view.state["world"], None)
            counted = view.until(lambda s: s["loading"]["blocks"] or s["page"] == "world", "a number of landblocks")
            self.assertIn(counted["loading"]["blocks"], (0, 9))
            first = view.page("world")
            self.assertEqual((first["world"], first["root"], first["overlays"]["panel"]), ("", "outside", False))
            self.assertTrue(0.3 < first["time"] < 0.7)
            self.assertEqual(first["hint"], 1.0)
            frames = first["frames"]
            self.assertTrue(7 <= view.until(lambda s: s["hint"] == 0.0, "no hints")["frames"] - frames <= 12)
            self.assertEqual(view.leave(), (0, ""))
        self.assertEqual(self.settings()["recent"], [""])

    def test_a_typed_directory_is_opened_and_remembered(self):
        world = self.demo("own world")
        with open(os.path.join(world, "world.json")) as file:
            changed = json.load(file)
        changed["start"] = "hill"
        with open(os.path.join(world, "world.json"), "w") as file:
            json.dump(changed, file)
        with self.open() as view:
            first = view.latest()
            view.menu()
            view.choose("Open a world")
            view.page("open")
            view.latest()
            view.do("key", "ctrl+a")
            view.do("type", self.path("own"))
            view.latest()
            view.press("Tab")  # completes the name
            view.latest()
            view.press("Return")
            view.until(lambda s: s["world"] == world, "its world")
            own = view.page("world")
            self.assertGreater(math.dist(own["eye"], first["eye"]), 20.0)
            view.until(lambda s: s["on_ground"], "it stands")
            last = view.latest()
            self.assertEqual(view.leave(), (0, ""))
        settings = self.settings()
        self.assertEqual(settings["recent"], [own["world"], ""])
        place = settings["last_places"][own["world"]]
        self.assertLess(math.dist((place["x"], place["y"], place["z"]), last["eye"]), 0.1)
        self.assertEqual(place["name"], "hill")
        self.assertEqual(settings["window"]["width"], 640)
        with self.open("--dat", own["world"], size="160x90") as view:
            self.assertLess(math.dist(view.state["eye"], last["eye"]), 0.1)

    def test_a_dropped_directory_is_opened(self):
        world = self.demo("dropped wörld")
        source = DragSource(self.display)
        try:
            with self.open() as view:
                uris = "file://" + urllib.parse.quote(world) + "\r\n"
                self.assertTrue(source.drop(view.window, 100, 100, uris))
                view.until(lambda s: s["world"] == world, "its world")
                view.page("world")
                self.assertTrue(source.drop(view.window, 100, 100, "file:///proc/nothing\r\n"))
                wrong = view.until(lambda s: s["error"], "the reason")
                self.assertIn("/proc/nothing", wrong["error"])
                self.assertEqual(wrong["world"], world)
        finally:
            source.close()

    def test_a_wrong_directory_shows_the_reason_and_the_world_stays(self):
        with self.open() as view:
            before = view.latest()
            view.menu()
            view.choose("Open a world")
            view.page("open")
            view.latest()
            view.do("key", "ctrl+a")
            view.do("type", "/proc/nothing")
            view.latest()
            view.choose("Open")
            wrong = view.until(lambda s: s["error"], "the reason")
            self.assertEqual(wrong["page"], "open")
            self.assertIn("/proc/nothing", wrong["error"])
            self.assertEqual(wrong["world"], "")
            view.press("Escape")
            view.page("menu")
            view.choose("Resume")
            again = view.page("world")
            self.assertLess(math.dist(again["eye"], before["eye"]), 0.5)
            code, errors = view.leave()
            self.assertEqual(code, 0)
            self.assertIn("/proc/nothing", errors)

    def test_a_wrong_directory_on_the_command_line_leads_to_the_open_page_but_ends_a_script(self):
        os.mkdir(self.path("empty"))
        with self.open("--dat", "empty", world=False, size="320x180") as view:
            wrong = view.until(lambda s: s["error"], "the reason")
            self.assertEqual((wrong["page"], wrong["world"]), ("open", None))
            self.assertIn("empty", wrong["error"])
            view.choose("Open the built-in world")
            view.page("world")
            self.assertEqual(view.leave()[0], 0)
        done = subprocess.run([PROGRAM, "view", "--dat", "empty", "--frames", "1", "--size", "64x64"], env=self.env, cwd=self.work.name,
                              capture_output=True, text=True, timeout=120)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)

    def test_keys_alone_drive_the_menu(self):
        with self.open() as view:
            view.press("Escape")
            view.page("menu")
            view.until(lambda s: s["focused"] == "Resume", "the first entry")
            seen = ["Resume"]
            while seen[-1] != "Graphics":
                view.press("Down")
                focused = view.until(lambda s: s["focused"] != seen[-1], "the next entry")["focused"]
                self.assertNotIn(focused, seen)
                seen.append(focused)
            view.press("Return")
            view.page("graphics")
            view.press("Escape")
            view.page("menu")
            view.press("Escape")
            view.page("world")
            self.assertEqual(view.leave(), (0, ""))

    def test_the_size_of_letters_starts_at_the_one_in_use(self):
        self.write_settings('{"ui_scale": 2.25}')
        with self.open("--ui-scale", "1") as view:
            view.menu()
            view.choose("Graphics")
            view.page("graphics")
            view.choose("ui scale")  # the middle of 0.5 to 4, equal to the settings
            view.until(lambda s: s["ui_scale"] == 2.25, "the size of the slider's middle")

    def test_a_click_captures_the_mouse_and_tab_releases_it(self):
        self.write_settings('{"ui_scale": 2.0, "mouse_sensitivity": 2.0, "theme": "of another program"}')
        with self.open("--ui-scale", "1.5", size="320x180") as view:
            self.assertEqual(view.state["ui_scale"], 1.5)
            view.do("mousemove", "160", "90")
            view.latest()
            view.do("click", "1")
            yaw = view.until(lambda s: s["captured"], "a captured mouse")["yaw"]
            view.do("mousemove_relative", "20", "0")
            turned = view.until(lambda s: s["yaw"] != yaw, "a turn")
            self.assertAlmostEqual(turned["yaw"] - yaw, 20 * 0.15 * 2.0, delta=1.0)
            view.press("Escape")
            self.assertFalse(view.page("menu")["captured"])
            view.press("Escape")
            self.assertTrue(view.page("world")["captured"])
            view.press("Tab")
            view.until(lambda s: not s["captured"], "a free mouse")
            self.assertEqual(view.leave(), (0, ""))
        self.assertEqual(self.settings()["theme"], "of another program")
        self.assertEqual(self.settings()["ui_scale"], 2.0)

    def test_signals_save_the_walk_and_its_full_path_is_reported(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.open("--record", "walk", size="64x64") as view:
                view.latest()
                view.view.send_signal(number)
                code, errors = view.end()
                self.assertEqual(code, 128 + number)
                self.assertIn(signal.Signals(number).name, errors)
                self.assertEqual(len(view.saved), 1)
                self.assertIn(self.path("walk"), view.saved[0])
            with open(self.path("walk")) as walk:
                lines = [json.loads(line) for line in walk]
            self.assertGreater(len(lines), 1)
            self.assertIn("last_places", self.settings())

    def test_a_full_disk_ends_with_an_error_that_names_the_file(self):
        with self.open("--record", "/dev/full", size="64x64") as view:
            view.latest()
            code, errors = view.leave()
            self.assertEqual(code, 2)
            self.assertIn("/dev/full", errors)
            self.assertIn("lines are saved", errors)


if __name__ == "__main__":
    unittest.main()
