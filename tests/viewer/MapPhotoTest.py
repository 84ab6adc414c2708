"""The map and photo mode, driven by real keys and mouse.

Usage: MapPhotoTest.py PROGRAM CACHE [unittest arguments]
"""

import json
import math
import os
import subprocess
import sys
import unittest

from WindowDriver import Followed, WindowTest, png_pixels

WindowTest.program = PROGRAM = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)


class MapPhoto(WindowTest):
    def open(self, *arguments):
        return Followed(self, "--radius", "1", "--far", "0", "--at", "cottage.front", *arguments, size="640x360")

    def test_the_map_opens_zooms_and_a_click_travels_in_a_walk_that_comes_out_the_same_again(self):
        with self.open("--fly", "--record", "walk") as view:
            before = view.latest()["eye"]
            view.press("m")
            view.page("map")
            view.until(lambda s: s["map"]["painted"] and "map" in s["items"], "a painted map")
            middle = view.state["items"]["map"]
            self.assertLess(math.dist(view.state["map"]["centre"], before[:2]), 600)
            nearer = view.state["map"]["metres_per_unit"]
            view.do("mousemove", str(round(middle[0]) + 60), str(round(middle[1]) - 40))
            pointed = view.until(lambda s: s["map"]["pointed"], "coordinates")["map"]["pointed"]
            self.assertRegex(pointed, r"^\d+\.\d[NS] \d+\.\d[EW]   block [0-9A-F]{4}$")
            view.do("click", "4")
            view.until(lambda s: s["map"]["metres_per_unit"] < nearer, "a nearer map")
            self.assertEqual(view.latest()["map"]["pointed"], pointed, "the point under the cursor stays")
            at = view.state["map"]
            x, y = (round(middle[0]) + 60, round(middle[1]) - 40)
            there = (at["centre"][0] + (x - middle[0]) * at["metres_per_unit"],
                     at["centre"][1] - (y - middle[1]) * at["metres_per_unit"])
            view.do("click", "1")
            view.page("world")
            gone = view.until(lambda s: math.dist(s["eye"][:2], there) < 2 * at["metres_per_unit"], "the clicked place")
            self.assertEqual(gone["root"], "outside")
            self.assertGreater(math.dist(gone["eye"], before), 20)
            view.latest()
            self.assertEqual(view.leave()[0], 0)
        with open(self.path("walk")) as file:
            acts = [act for line in file for act in json.loads(line).get("acts", [])]
        self.assertEqual([act[0] for act in acts if act[0] == "go"], ["go"])
        again = subprocess.run([PROGRAM, "probe", "--walk", "walk"], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=240)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("differs", again.stderr)

    def test_a_place_is_found_by_its_name_and_gone_to(self):
        with self.open() as view:
            view.press("m")
            view.page("map")
            view.choose("search")
            view.do("type", "INN.HA")
            view.until(lambda s: "inn.hall" in s["items"] and "hill" not in s["items"], "the place alone")
            self.assertEqual(view.state["page"], "map", "letters in the field are no keys")
            view.choose("inn.hall")
            view.page("world")
            view.until(lambda s: s["root"].startswith("0x"), "the hall")
            self.assertEqual(view.leave()[0], 0)

    def world_with_people(self):
        """The built-in world, whose doors and people stand in a world.db."""
        def limen(*arguments):
            done = subprocess.run([PROGRAM, *arguments], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stderr)
        limen("demo", "-o", "placed")
        limen("world", "export", "--dat", "placed", "--as", "sql", "-o", "rows")
        limen("world", "import", "rows", "--dat", "placed")
        with open(self.path("placed/world.json")) as file:
            world = json.load(file)
        world.update(doors=[], villagers=[])
        with open(self.path("placed/world.json"), "w") as file:
            json.dump(world, file)

    def test_a_person_is_searched_named_and_marked_and_the_walk_comes_out_the_same_again(self):
        self.world_with_people()
        with self.open("--dat", "placed", "--record", "walk") as view:
            view.press("slash")
            view.page("places")
            view.do("type", "innkeep")
            label = next(name for name in view.until(lambda s: any(n.startswith("innkeeper") for n in s["items"]), "the innkeeper")["items"]
                         if name.startswith("innkeeper"))
            self.assertRegex(label, r"^innkeeper   creature, \d+ m, indoors$")
            view.press("Return")
            view.page("world")
            view.until(lambda s: s["root"].startswith("0x"), "the inn")
            self.assertEqual(view.latest()["names"], [])
            view.press("n")
            self.assertEqual(view.until(lambda s: s["names"], "names")["names"][0], "innkeeper")
            view.press("n")
            view.until(lambda s: not s["names"], "no names")
            view.press("m")
            view.page("map")
            view.until(lambda s: "doors" in s["items"], "the switch of the doors' marks")
            self.assertNotIn("portals", view.state["items"], "this world has none")
            view.press("Escape")
            view.page("world")
            self.assertEqual(view.leave()[0], 0)
        with open(self.path("walk")) as file:
            acts = [act for line in file for act in json.loads(line).get("acts", [])]
        self.assertIn("object", [act[0] for act in acts])
        again = subprocess.run([PROGRAM, "probe", "--dat", "placed", "--walk", "walk"], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=240)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("differs", again.stderr)

    def test_large_letters_in_a_small_window_leave_every_control_in_reach(self):
        with self.open("--ui-scale", "2") as view:
            width, height = view.latest()["size"]
            view.menu()
            view.choose("Places")
            view.page("places")
            view.choose("inn.hall")
            view.page("world")
            view.until(lambda s: s["root"].startswith("0x"), "the hall")
            view.menu()
            view.choose("Controls")
            view.page("controls")
            view.choose("Back")
            view.page("menu")
            view.press("Escape")
            view.page("world")
            view.press("m")
            view.page("map")
            for name in ("Whole map", "Back"):
                x, y = view.until(lambda s: name in s["items"], name)["items"][name]
                self.assertTrue(0 < x < width - 20 and 0 < y < height - 10, f"{name} at {x}, {y}")
            view.choose("Back")
            view.page("world")
            self.assertEqual(view.leave()[0], 0)

    def test_photo_mode_takes_a_picture_and_leaves_the_world_as_it_was(self):
        with self.open("--screenshots", "pictures", "--fly") as view:
            os.makedirs(self.path("pictures"), exist_ok=True)
            view.press("p")
            view.page("photo")
            before = view.until(lambda s: s["photo"], "photo mode")
            view.do("keydown", "w")
            view.until(lambda s: math.dist(s["photo"]["eye"], before["photo"]["eye"]) > 0.3, "a camera that flies")
            view.do("keyup", "w")
            view.choose("Time of day")  # the middle of the slider: noon
            view.until(lambda s: abs(s["photo"]["time"] - 0.5) < 0.02, "noon")
            view.do("mousemove", "520", "345")  # over the controls, beside all of them
            while "Samples a pixel" not in view.latest()["items"]:
                view.do("click", "5")
            view.choose("Samples a pixel")
            view.until(lambda s: "2 x 2" in s["items"], "the list")
            view.choose("2 x 2")
            view.until(lambda s: s["photo"]["supersample"] == 2, "supersampling")
            view.press("Return")
            saved = view.until(lambda s: s["photo"]["saved"], "a saved picture")["photo"]["saved"]
            self.assertEqual(os.path.realpath(saved), os.path.realpath(self.path("pictures", "limen-0001.png")))
            self.assertTrue(os.path.isabs(saved))
            view.press("p")
            after = view.page("world")
            for name in ("eye", "yaw", "time", "seconds", "weather", "day", "root"):
                if name != "seconds":
                    self.assertEqual(after[name], before[name], name)
            self.assertLess(after["seconds"] - before["seconds"], 0.2, "time stood still")
            self.assertEqual(view.leave()[0], 0)
        with open(self.path("pictures", "limen-0001.txt")) as file:
            command = file.read().split()
        self.assertIn("--supersample", command)
        subprocess.run([PROGRAM, *command[1:]], env=self.env, cwd=self.path("pictures"), check=True, timeout=120)
        kept, again = (png_pixels(self.path("pictures", name)) for name in ("limen-0001.png", "limen-0001-again.png"))
        self.assertEqual(kept[:2], (640, 360))
        differing = sum(a != b for a, b in zip(kept[2], again[2]))
        self.assertLess(differing, len(kept[2]) // 1000)


if __name__ == "__main__":
    unittest.main()
