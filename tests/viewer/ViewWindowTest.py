"""The window, driven by real key events on its own X server.

Usage: ViewWindowTest.py PROGRAM CACHE [unittest arguments]
"""

import functools
import json
import math
import os
import subprocess
import sys
import unittest

from WindowDriver import Followed, WindowTest, png_pixels

WindowTest.program = PROGRAM = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)


def patiently(test):
    """Repeats a failed test once with longer waits. On a busy machine the first frames take seconds, and keys pressed and
    released in between are lost."""
    @functools.wraps(test)
    def run(self):
        try:
            test(self)
        except AssertionError:
            self.patience = 5
            test(self)
    return run


class ViewWindow(WindowTest):
    def xdotool(self, *arguments):
        self.ask(*arguments)

    def script(self, *arguments):
        """Runs the window for a number of frames. Returns its output."""
        done = subprocess.run([PROGRAM, "view", "--size", "480x270", "--json", *arguments], env=self.env, cwd=self.work.name,
                              capture_output=True, text=True, timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def drive(self, steps, *arguments):
        """Opens the window, runs `steps` to press keys, ends it with Ctrl-C. Returns the last state; the probe's events are in
        `self.probed`."""
        with Followed(self, *arguments, step=None) as view:
            self.xdotool("mousemove", "440", "240")
            view.latest()
            self.wait(0.7)
            steps()
            self.wait(0.7)
            last = view.interrupt()
            self.probed = view.events
        return last

    def hold(self, key, seconds):
        self.xdotool("keydown", key)
        self.wait(seconds)
        self.xdotool("keyup", key)

    def test_runs_its_frames_and_writes_the_last(self):
        state = self.script("--frames", "5", "--screenshot", "a.png")
        self.assertEqual(state["frames"], 5)
        width, height, pixels = png_pixels(os.path.join(self.work.name, "a.png"))
        self.assertEqual((width, height), (480, 270))
        self.assertGreater(len(set(pixels[i:i + 3] for i in range(0, len(pixels), 3))), 100)

    def test_escape_opens_the_menu_and_quit_is_in_it(self):
        with Followed(self, "--at", "cottage.room", size="320x180") as view:
            before = view.latest()
            view.press("Escape")
            view.page("menu")
            view.press("Escape")
            view.page("world")
            self.assertEqual(view.state["eye"], before["eye"])
            self.assertEqual(view.leave(), (0, ""))

    @patiently
    def test_w_flies_forward_and_d_to_the_right(self):
        still = self.drive(lambda: None, "--at", "hill", "--yaw", "0", "--pitch", "0")
        moved = self.drive(lambda: (self.hold("w", 0.8), self.hold("d", 0.8)), "--fly", "--at", "hill", "--yaw", "0", "--pitch", "0")
        self.assertGreater(moved["eye"][1], still["eye"][1] + 0.2)
        self.assertGreater(moved["eye"][0], still["eye"][0] + 0.2)

    @patiently
    def test_w_walks_on_the_floor_until_a_wall_and_g_flies(self):
        view = ("--at", "cottage.room", "--yaw", "90")
        still = self.drive(lambda: None, *view)
        self.assertTrue(still["walking"] and still["on_ground"])
        moved = self.drive(lambda: self.hold("w", 3), *view)
        self.assertGreater(moved["eye"][0], still["eye"][0] + 0.2)
        self.assertLess(moved["eye"][0], still["eye"][0] + 10.35)  # the wall
        self.assertAlmostEqual(moved["eye"][2], still["eye"][2], delta=0.02)
        self.assertTrue(moved["on_ground"])
        flown = self.drive(lambda: (self.xdotool("key", "g"), self.wait(0.3), self.hold("e", 0.5)), *view)
        self.assertFalse(flown["walking"])
        self.assertGreater(flown["eye"][2], still["eye"][2] + 0.1)

    @patiently
    def test_e_shuts_the_door_before_one_and_opens_it(self):
        view = ("--eye=32532.1,34664.6,32.0", "--yaw", "0", "--pitch", "0")

        def use(times):
            for _ in range(times):
                self.xdotool("key", "e")
                self.wait(1.5)

        still = self.drive(lambda: None, *view)
        self.assertIn("cottage.front", still["open_doors"])
        shut = self.drive(lambda: use(1), *view)
        self.assertEqual(set(still["open_doors"]) - set(shut["open_doors"]), {"cottage.front"})
        self.assertLess(shut["visits"], still["visits"])
        self.assertEqual(self.drive(lambda: use(2), *view)["open_doors"], still["open_doors"])
        stopped = self.drive(lambda: (use(1), self.hold("w", 2)), *view)
        self.assertEqual(stopped["root"], "outside")
        self.assertNotEqual(self.drive(lambda: self.hold("w", 2), *view)["root"], "outside")

    @patiently
    def test_c_puts_the_eye_behind_the_body_and_the_wheel_brings_it_nearer(self):
        def apart(state):
            return math.dist(state["eye"], state["body"]["feet"])

        view = ("--at", "cottage.front", "--yaw", "0", "--pitch", "0")
        head = self.drive(lambda: None, *view)
        self.assertFalse(head["chased"])
        self.assertEqual(head["body"]["opacity"], 0)
        behind = self.drive(lambda: (self.xdotool("key", "c"), self.wait(2)), *view)
        self.assertTrue(behind["chased"])
        self.assertEqual(behind["body"]["opacity"], 1)
        self.assertLess(behind["eye"][1], head["eye"][1] - 1.5)
        near = self.drive(lambda: (self.xdotool("key", "c"), self.wait(2), self.xdotool("click", "4"), self.wait(0.3), self.xdotool("click", "4"),
                                   self.wait(0.5)), *view)
        self.assertLess(apart(near), apart(behind) - 0.3)
        again = self.drive(lambda: (self.xdotool("key", "c"), self.wait(1), self.xdotool("key", "c"), self.wait(0.5)), *view)
        self.assertEqual(again["eye"], head["eye"])

    def test_a_recorded_walk_comes_out_the_same_again(self):
        def walk():
            self.hold("w", 1)
            self.xdotool("key", "c")
            self.hold("w", 1)
            self.xdotool("key", "e")
            self.wait(0.5)
            self.xdotool("key", "r")
            self.xdotool("key", "5")
            self.hold("d", 1)
            self.xdotool("key", "g")
            self.hold("q", 0.5)

        last = self.drive(walk, "--at", "cottage.front", "--record", "walk")
        self.assertGreater(last["frames"], 5)
        again = subprocess.run([PROGRAM, "probe", "--walk", "walk"], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=240)
        self.assertEqual(again.returncode, 0, again.stderr)
        events = [json.loads(line) for line in again.stdout.splitlines()]
        self.assertEqual([e["root"] for e in events if e["event"] == "root"][-1], last["root"])

    def replay(self, walk):
        """Returns a walk's recorded frames and the events of its replay, which must equal the recording."""
        with open(os.path.join(self.work.name, walk)) as file:
            lines = [json.loads(line) for line in file]
        again = subprocess.run([PROGRAM, "probe", "--walk", walk], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=240)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("differs", again.stderr)
        return lines, [json.loads(line) for line in again.stdout.splitlines()]

    def test_a_flight_into_other_blocks_comes_out_the_same_again(self):
        # Over the eastern border of a block, beyond the hysteresis: blocks are streamed in.
        with Followed(self, "--fly", "--eye=32440,34850,120", "--yaw", "90", "--pitch", "0", "--record", "flight", size="160x90") as view:
            self.assertEqual(view.state["loaded"], [168, 181])
            for key in ("shift", "w"):
                view.do("keydown", key)
            view.until(lambda state: state["eye"][0] > 32448 + 30, "a flight over the border")
            for key in ("w", "shift"):
                view.do("keyup", key)
            view.until(lambda state: state["loaded"] == [169, 181], "the next part of the world")
            view.latest()
            self.assertEqual(view.leave(), (0, ""))
        lines, told = self.replay("flight")
        self.assertEqual(lines[0]["streamed"]["far"], 12)
        self.assertEqual([line["shown"]["x"] for line in lines if "shown" in line], [169])
        self.assertTrue([event for event in told if event["event"] == "loaded"])

    def test_places_far_away_are_gone_to_while_the_world_is_drawn_and_come_out_the_same_again(self):
        # Block by block, so that the next part is far away.
        with Followed(self, "--at", "cottage.front", "--radius", "0", "--far", "0", "--record", "jumps", size="160x90") as view:
            before = view.state["eye"]
            view.press("1")
            there = view.until(lambda state: state["loaded"] == [170, 181], "the cave")
            self.assertGreater(math.dist(there["eye"], before), 100)
            self.assertEqual(there["going_to"], "")
            view.press("3")
            back = view.until(lambda state: state["loaded"] == [169, 180], "the cottage")
            self.assertLess(math.dist(back["eye"], before), 1)
            view.latest()
            self.assertEqual(view.leave(), (0, ""))
        lines, told = self.replay("jumps")
        asked = [i for i, line in enumerate(lines) if any(act[0] == "place" for act in line.get("acts", []))]
        shown = [i for i, line in enumerate(lines) if "shown" in line]
        self.assertEqual((len(asked), len(shown)), (2, 2))
        self.assertGreater(shown[0], asked[0], "frames go on meanwhile")
        self.assertTrue([event for event in told if event["event"] == "loaded"])

    @patiently
    def test_f6_tells_what_changes_until_it_is_pressed_again(self):
        def probe():
            self.xdotool("key", "F6")
            self.wait(1)
            self.xdotool("key", "2")  # another place
            self.wait(1)
            self.xdotool("key", "F6")
            self.wait(1)
            self.xdotool("key", "3")
            self.wait(1)

        self.drive(probe, "--at", "cottage.room")
        roots = [event["root"] for event in self.probed if event["event"] == "root"]
        self.assertEqual(roots, ["0xA9B40100", "0xA9B40105"])
        self.drive(lambda: None, "--at", "cottage.room")
        self.assertEqual(self.probed, [])

    def test_keys_are_those_of_the_file_and_change_in_the_window(self):
        keys = self.path("keys.json")
        with open(keys, "w") as file:
            json.dump({"rain": "K"}, file)
        with Followed(self, "--keys", keys, "--at", "cottage.room", size="800x600") as view:
            view.press("r")
            view.press("k")
            view.until(lambda s: s["weather"] == "rain", "rain by the key of the file")
            view.press("F1")
            view.page("controls")
            view.choose("key use")
            view.until(lambda s: s["rebinding"], "a key is waited for")
            view.press("Escape")
            view.until(lambda s: not s["rebinding"], "Escape lets go of it")
            self.ask("click", "1")
            self.assertEqual(view.until(lambda s: s["rebinding"], "a key is waited for")["rebinding"], "use")
            view.press("h")
            view.until(lambda s: s["keys"] == {"use": ["H"], "rain": ["K"]}, "the new key")
            with open(keys) as file:
                self.assertEqual(json.load(file), {"use": ["H"], "rain": ["K"]})
            self.assertEqual(view.leave()[0], 0)

    def test_a_keys_file_that_is_wrong_is_refused_in_a_line(self):
        os.makedirs(self.path("config", "limen"))
        for text, what in (('{"fly": "F"}', "fly: unknown action"), ('{"use": "Esc"}', "use: unknown key 'Esc'"),
                           ('{"use": "G"}', "use: G is already the key of walk")):
            with open(self.path("config", "limen", "keys.json"), "w") as file:
                file.write(text)
            done = subprocess.run([PROGRAM, "view", "--frames", "1"], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertIn("limen/keys.json, " + what, done.stderr)

    def test_f12_keeps_the_picture_and_what_draws_it_again(self):
        with Followed(self, "--at", "cottage.front", "--screenshots", "pictures", size="480x270") as view:
            for number in ("0001", "0002"):
                view.press("F12")
                view.until(lambda s: s["notice"] == "Saved " + self.path("pictures", f"limen-{number}.png"), "the path on the screen")
            self.assertEqual(view.leave()[0], 0)
        with open(self.path("pictures", "limen-0002.txt")) as file:
            command = file.read().split()
        self.assertEqual(command[:2], ["limen", "shot"])
        subprocess.run([PROGRAM, *command[1:]], env=self.env, cwd=self.path("pictures"), check=True, timeout=120)
        kept, again = (png_pixels(self.path("pictures", name)) for name in ("limen-0002.png", "limen-0002-again.png"))
        self.assertEqual(kept[:2], (480, 270))
        self.assertEqual(kept, again)

    def test_the_wheel_takes_the_eye_out_of_the_head_and_back(self):
        with Followed(self, "--at", "cottage.front", "--yaw", "0", "--pitch", "0") as view:
            self.ask("mousemove", "440", "240")
            view.until(lambda s: s["on_ground"], "it stands")
            self.ask("click", "5")
            self.assertEqual(view.until(lambda s: s["chased"], "behind the body")["distance"], 1.0)
            self.ask("click", "5")
            view.until(lambda s: s["distance"] == 1.5, "farther")
            self.ask("click", "4")
            view.until(lambda s: s["distance"] == 1.0, "nearer")
            self.assertTrue(view.state["chased"])
            self.ask("click", "4")
            view.until(lambda s: not s["chased"], "in the head again")
            self.assertEqual(view.leave()[0], 0)

    def test_portals_are_shown_with_what_became_of_them(self):
        with Followed(self, "--at", "cottage.room", "--yaw", "150", "--pitch", "0", size="320x180") as view:
            self.assertEqual(view.state["portals"], {})
            view.press("F8")
            shown = view.until(lambda s: s["overlays"]["portals"], "portals")
            self.assertEqual(shown["portals"]["admitted"], shown["visits"] - 1)
            self.assertGreater(shown["portals"]["the eye is behind it"], 0)
            view.press("o")  # they swing open first, because some are closed in the data
            view.until(lambda s: s["doors"] == 1.0, "all doors are open")
            view.press("o")
            shut = view.until(lambda s: s["doors"] == 0.0, "all doors are shut")
            self.assertGreater(shut["portals"]["shut"], 0)
            view.press("F8")
            view.until(lambda s: s["portals"] == {}, "no portals")
            self.assertEqual(view.leave(), (0, ""))

    @patiently
    def test_function_keys_switch_the_overlays(self):
        def press():
            for key in ("F2", "F9", "F3", "F8", "F4", "F1"):
                self.xdotool("key", key)
                self.wait(0.4)

        state = self.drive(press)
        self.assertEqual(state["overlays"], {"ids": True, "depth": True, "regions": True, "portals": True, "names": False, "panel": True})
        self.assertEqual(state["page"], "controls")

    def test_f10_and_the_panel_choose_the_gate(self):
        with Followed(self, "--at", "cottage.room", size="640x360") as view:
            self.assertEqual(view.state["gate"], "ownership")
            calls = view.until(lambda s: s["frames"] > 3, "steady frames")["gl_calls"]
            for gate in ("planes", "depth"):
                view.press("F10")
                view.until(lambda s: s["gate"] == gate, gate)
                view.until(lambda s: s["gl_calls"] != calls, f"frames that {gate} draws", frames=20)
            view.press("F10")
            view.until(lambda s: s["gate"] == "ownership", "the first gate again")
            view.press("F4")
            view.until(lambda s: s["overlays"]["panel"], "the panel")
            if "panel gate planes" not in view.latest()["items"]:
                view.choose("tab Developer")
            view.choose("panel gate planes")
            view.until(lambda s: s["gate"] == "planes", "planes by the panel")
            self.assertEqual(view.leave(), (0, ""))

    @patiently
    def test_o_opens_the_doors_r_makes_rain_and_t_makes_it_later(self):
        def press():
            for key in ("o", "r", "t"):
                self.xdotool("key", key)
                self.wait(0.4)
            self.wait(1.0)

        still, changed = self.drive(lambda: None), self.drive(press)
        self.assertEqual((still["doors"], still["weather"]), (None, "clear"))
        self.assertGreater(changed["doors"], 0.0)
        self.assertEqual(changed["weather"], "rain")
        self.assertAlmostEqual(changed["time"], still["time"] + 1.0 / 24.0)

    @patiently
    def test_number_keys_go_to_places(self):
        first = self.drive(lambda: self.xdotool("key", "1"))
        second = self.drive(lambda: self.xdotool("key", "2"))
        self.assertNotEqual(first["eye"], second["eye"])

    def test_flying_through_a_door_changes_the_root(self):
        outside = self.drive(lambda: None, "--at", "cottage.front")
        inside = self.drive(lambda: None, "--at", "cottage.room")
        self.assertEqual(outside["root"], "outside")
        self.assertTrue(inside["root"].startswith("0x"))


if __name__ == "__main__":
    unittest.main()
