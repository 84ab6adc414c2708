"""The scale of the 3-D picture: the control of the frame rate, and all that must not depend on the scale.

Usage: ViewScaleTest.py PROGRAM CACHE [unittest arguments]
"""

import json
import os
import subprocess
import sys
import unittest

from WindowDriver import Followed, WindowTest, png_pixels

WindowTest.program = PROGRAM = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)

SIZE = "480x270"
ROOM = ("--at", "cottage.room", "--yaw", "90", "--pitch", "-10")


class ViewScale(WindowTest):
    def panel(self, view):
        """The places of the panel's controls."""
        return {name: place for name, place in view.latest()["items"].items() if name.startswith(("panel", "tab"))}

    def choose_entry(self, view, control, entry):
        view.choose(control)
        view.until(lambda s: entry in s["items"], "the list of " + control)
        view.choose(entry)

    def rate(self, view, entry):
        """Chooses a frame rate on the page Graphics."""
        view.menu()
        view.choose("Graphics")
        view.page("graphics")
        self.choose_entry(view, "frame rate", entry)
        view.latest()
        for page in ("menu", "world"):
            view.press("Escape")
            view.page(page)

    def test_a_tight_rate_lowers_the_scale_and_a_loose_one_brings_full_size_back(self):
        with Followed(self, "--at", "cottage.cellar", "--fps", "1000", size="640x480") as view:
            view.press("F4")
            view.until(lambda s: s["overlays"]["panel"], "the panel")
            small = view.until(lambda s: s["scale"]["percent"] == 50, "the least scale")
            self.assertEqual(small["scale"]["drawn"], [320, 240])
            self.assertEqual(small["size"], [640, 480])
            self.assertTrue(small["scale"]["automatic"])
            before = self.panel(view)
            self.assertIn("panel scale", before)
            self.rate(view, "5 a second")
            large = view.until(lambda s: s["scale"]["percent"] == 100, "full size")
            self.assertEqual(large["scale"]["drawn"], [640, 480])
            self.assertEqual(large["scale"]["frame_rate"], 5)
            self.assertEqual(self.panel(view), before)
            self.assertEqual(view.leave()[0], 0)
        with open(self.path("config", "limen", "settings.json")) as file:
            settings = json.load(file)
        self.assertEqual((settings["scale"], settings["frame_rate"]), ("auto", 5))

    def test_a_scale_chosen_in_the_panel_holds_and_is_kept(self):
        with Followed(self, *ROOM, "--scale", "auto", "--fps", "5", size=SIZE) as view:
            view.press("F4")
            self.choose_entry(view, "panel scale", "60 %")
            fixed = view.until(lambda s: s["scale"]["percent"] == 60, "60 %")["scale"]
            self.assertFalse(fixed["automatic"])
            self.assertEqual(fixed["drawn"], [288, 162])
            for _ in range(40):
                self.assertEqual(view.next()["scale"]["percent"], 60)
            self.assertEqual(view.leave()[0], 0)
        with Followed(self, *ROOM, size=SIZE) as view:
            self.assertEqual(view.latest()["scale"]["percent"], 60)
            self.assertEqual(view.leave()[0], 0)

    def test_a_click_inspects_the_same_object_at_any_scale(self):
        picked = {}
        for scale in ("50", "73", "100"):
            with Followed(self, *ROOM, "--scale", scale, size=SIZE) as view:
                view.press("F4")
                view.until(lambda s: s["overlays"]["panel"], "the panel")
                seen = []
                for x, y in ((440, 60), (400, 250), (430, 160)):
                    view.do("mousemove", str(x), str(y))
                    view.latest()
                    view.do("click", "1")
                    before = seen[-1] if seen else None
                    seen.append(view.until(lambda s: s["picked"] and s["picked"] != before, "an object")["picked"])
                picked[scale] = seen
                view.interrupt()
        self.assertEqual(picked["50"], picked["100"])
        self.assertEqual(picked["73"], picked["100"])

    def test_a_screenshot_has_full_size_and_is_drawn_again_by_its_command(self):
        os.makedirs(self.path("pictures"))
        with Followed(self, *ROOM, "--scale", "50", "--screenshots", "pictures", size=SIZE) as view:
            view.press("F12")
            view.until(lambda s: os.path.exists(self.path("pictures", "limen-0001.txt")), "a picture")
            self.assertEqual(view.latest()["scale"]["drawn"], [240, 135])
            view.interrupt()
        kept = png_pixels(self.path("pictures", "limen-0001.png"))
        self.assertEqual(kept[:2], (480, 270))
        with open(self.path("pictures", "limen-0001.txt")) as file:
            command = file.read().split()
        subprocess.run([PROGRAM, *command[command.index("shot"):]], env=self.env, cwd=self.work.name, check=True, timeout=240)
        again = png_pixels(self.path("limen-0001-again.png"))
        differing = sum(kept[2][i:i + 3] != again[2][i:i + 3] for i in range(0, len(kept[2]), 3))
        self.assertLessEqual(differing, 0.01 * 480 * 270)  # the text rounds the eye; an enlarged picture differs nearly everywhere

    def test_a_photo_has_full_size(self):
        os.makedirs(self.path("pictures"))
        with Followed(self, *ROOM, "--scale", "50", "--screenshots", "pictures", size=SIZE) as view:
            view.press("p")
            view.page("photo")
            view.until(lambda s: s["photo"], "photo mode")
            view.press("Return")
            saved = view.until(lambda s: s["photo"]["saved"], "a saved picture")["photo"]["saved"]
            view.interrupt()
        self.assertEqual(png_pixels(saved)[:2], (480, 270))

    def test_the_check_compares_the_pixels_that_are_drawn(self):
        with Followed(self, *ROOM, "--scale", "50", "--draw", "exact", size="322x182") as view:
            view.press("F5")
            checked = view.until(lambda s: s["checked"], "a verdict")
            self.assertEqual(checked["scale"]["drawn"], [161, 91])
            self.assertEqual(checked["checked"], {"pixels": 161 * 91, "wrong": 0})
            view.interrupt()

    def test_scripts_draw_full_size(self):
        done = subprocess.run([PROGRAM, "view", "--size", "320x180", "--json", "--frames", "3"], env=self.env, cwd=self.work.name, capture_output=True,
                              text=True, timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["scale"]["drawn"], [320, 180])
        for wrong in ("49", "101", "fast"):
            done = subprocess.run([PROGRAM, "view", "--scale", wrong, "--frames", "1"], env=self.env, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--scale", done.stderr)


if __name__ == "__main__":
    unittest.main()
