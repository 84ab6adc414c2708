"""The key that opens doors, at chests of a world database. The window imports their rows itself.

Usage: PlacedKeysTest.py PROGRAM CACHE [unittest arguments]
"""

import json
import math
import os
import subprocess
import sys
import unittest

from WindowDriver import Followed, WindowTest

WindowTest.program = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)


class PlacedKeys(WindowTest):
    """The built-in world with one chest on the lane, 1.6 m east of a place. Its lid is a door leaf."""

    def chest(self, locked):
        world = os.path.join(self.work.name, "world")
        subprocess.run([self.program, "demo", world], check=True, env=self.env, capture_output=True)
        with open(os.path.join(world, "world.json")) as file:
            facts = json.load(file)
        leaf = next(leaf for door in facts["doors"] for leaf in door["leaves"] if "motionTable" in leaf)
        lane = facts["places"]["lane"]
        x, y = lane["x"] + 1.6, lane["y"]
        bx, by = math.floor(x / 192), math.floor(y / 192)
        with open(os.path.join(self.work.name, "rows.sql"), "w") as rows:
            rows.write(f"""
                INSERT INTO weenie (class_Id, class_Name, type) VALUES (7, 'strongbox', 20);
                INSERT INTO weenie_properties_string (object_Id, type, value) VALUES (7, 1, 'Strongbox');
                INSERT INTO weenie_properties_bool (object_Id, type, value) VALUES (7, 3, {locked});
                INSERT INTO weenie_properties_d_i_d (object_Id, type, value) VALUES (7, 1, {leaf["model"]}), (7, 2, {leaf["motionTable"]});
                INSERT INTO landblock_instance (guid, weenie_Class_Id, obj_Cell_Id, origin_X, origin_Y, origin_Z, angles_W, angles_X,
                    angles_Y, angles_Z, is_Link_Child) VALUES ({0x7A9B4001}, 7, {bx << 24 | by << 16}, {x - 192 * bx}, {y - 192 * by},
                    {lane["z"] - 1.7}, 1, 0, 0, 0, False);""")
        return ["--dat", world, "--import", "rows.sql", "--at", "lane", "--yaw", "90", "--pitch", "-20"]

    def test_a_chest_opens_and_shuts(self):
        with Followed(self, *self.chest("False")) as view:
            name = view.until(lambda s: s["door"], "a chest in reach")["door"]
            self.assertTrue(name.startswith("Strongbox"), name)
            view.press("e")
            view.until(lambda s: name in s["open_doors"], "an open chest")
            view.press("e")
            view.until(lambda s: name not in s["open_doors"], "a shut chest")
            self.assertFalse(view.state["door_refused"])

    def test_a_locked_chest_stays_shut_and_says_so(self):
        with Followed(self, *self.chest("True")) as view:
            name = view.until(lambda s: s["door"], "a chest in reach")["door"]
            view.press("e")
            view.until(lambda s: s["door_refused"], "the refusal")
            picture = os.environ.get("LIMEN_KEEP_PICTURE")
            if picture:
                subprocess.run(["import", "-window", "root", picture], env=self.env, check=True)
            view.until(lambda s: not s["door_refused"], "the end of the line")
            self.assertNotIn(name, view.state["open_doors"])


if __name__ == "__main__":
    unittest.main()
