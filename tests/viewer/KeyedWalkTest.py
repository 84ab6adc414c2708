"""Somebody walks from the cellar to the inn's balcony and runs back in the rain, with real keys and a real mouse: every turn and step is
decided by the frames that are told, none by a clock. The walk is played again and must come out the same, frame by frame.

Usage: KeyedWalkTest.py PROGRAM CACHE [unittest arguments]
LIMEN_WALK_KEEP: a directory that keeps the pictures and the walk.
"""

import ctypes
import json
import math
import os
import shutil
import subprocess
import sys
import unittest

from WindowDriver import Followed, WindowTest

WindowTest.program = PROGRAM = sys.argv.pop(1)
WindowTest.cache = sys.argv.pop(1)


class Hands:
    """Sends keys and mouse events through the X server's test extension."""

    RIGHT_BUTTON = 3

    def __init__(self, display):
        self.x = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))
        self.held = set()

    def key(self, name, down):
        if down != (name in self.held):
            (self.held.add if down else self.held.discard)(name)
            code = self.x.XKeysymToKeycode(self.display, ctypes.c_ulong(self.x.XStringToKeysym(name.encode())))
            self.test.XTestFakeKeyEvent(self.display, code, int(down), ctypes.c_ulong(0))
            self.x.XFlush(self.display)

    def tap(self, name):
        self.key(name, True)
        self.key(name, False)

    def button(self, down):
        self.test.XTestFakeButtonEvent(self.display, self.RIGHT_BUTTON, int(down), ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def move(self, x, y):
        self.test.XTestFakeRelativeMotionEvent(self.display, x, y, ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def close(self):
        for name in list(self.held):
            self.key(name, False)
        self.x.XCloseDisplay(self.display)


class KeyedWalk(WindowTest):
    REACHED = 0.45  # horizontal metres from a way point
    DEGREES_A_PIXEL = 0.15
    PATIENCE = 60  # frames without progress
    WORLD = ("--radius", "1")  # the path is within two landblocks

    def way(self):
        """The built-in world's tour from the cellar to the balcony, as foot positions."""
        subprocess.run([PROGRAM, "demo", self.path("world")], env=self.env, check=True, capture_output=True)
        with open(self.path("world", "world.json")) as file:
            world = json.load(file)
        places = {name: (place["x"], place["y"], place["z"]) for name, place in world["places"].items()}
        tour = [(point["x"], point["y"], point["z"]) for point in world["tour"]]

        def nearest(name, start):
            return min(range(start, len(tour)), key=lambda i: round(math.dist(tour[i], places[name]), 2))

        cellar = nearest("cottage.cellar", 0)
        hall = nearest("inn.hall", cellar)
        balcony = nearest("inn.balcony", hall)
        points = [tour[cellar]]
        for point in tour[cellar:balcony + 1]:
            if math.dist(point, points[-1]) > 0.8:
                points.append(point)
        return points

    def turn_towards(self, view, target):
        """Moves the mouse so that the next frames look there. Returns the error of this frame in degrees."""
        feet = view.state["body"]["feet"]
        wanted = math.degrees(math.atan2(target[0] - feet[0], target[1] - feet[1]))
        off = (wanted - view.state["yaw"] + 180.0) % 360.0 - 180.0
        nod = 0.0 - view.state["pitch"]
        self.hands.move(round(off * 0.4 / self.DEGREES_A_PIXEL), round(-nod * 0.2 / self.DEGREES_A_PIXEL))
        return off

    def open_door(self, view):
        """Opens a closed door in reach and waits until it is open. Returns whether there was one."""
        door = view.state["door"]
        if not door or door in view.state["open_doors"]:
            return False
        self.hands.key("w", False)
        self.hands.tap("e")
        view.until(lambda s: door in s["open_doors"], f"{door} opens", 60)
        self.opened.append(door)
        for _ in range(25):  # the swing takes a second
            view.next()
        return True

    def go_to(self, view, point):
        """Returns whether the body arrived. False after opening a door, because its leaf can push the body aside."""
        def distance():
            feet = view.state["body"]["feet"]
            return math.dist(feet[:2], point[:2])

        best, waited = distance(), 0
        while distance() > self.REACHED:
            off = self.turn_towards(view, point)
            self.hands.key("w", abs(off) < 35.0)
            view.latest()
            if waited > 10 and self.open_door(view):
                return False
            waited = 0 if distance() < best - 0.02 else waited + 1
            best = min(best, distance())
            self.assertLess(waited, self.PATIENCE, f"stuck before {point}: {view.state}")
        self.roots.add(view.state["root"])
        return True

    def walk(self, view, points):
        at = 0
        while at < len(points):
            if self.go_to(view, points[at]):
                at += 1
            else:
                at = max(at - 3, 0)  # tries again, around the open leaf
        self.hands.key("w", False)
        view.latest()

    def picture(self, view):
        before = view.state["notice"]
        self.hands.tap("F12")
        view.until(lambda s: s["notice"] not in ("", before), "a picture")  # a key takes many frames at a load: 330 a second are drawn

    def test_from_the_cellar_to_the_balcony_and_back_in_the_rain(self):
        points = self.way()
        self.roots, self.opened = set(), []
        floor = points[0][2] - 1.7
        ground = next(i for i, p in enumerate(points) if p[2] > floor + 3.5)  # the first point above the cellar
        out = next(i for i, p in enumerate(points) if p[1] < points[ground][1] - 8.0)
        inn = next(i for i in range(out, len(points)) if points[i][1] > points[out][1] + 7.0)
        with Followed(self, "--at", "cottage.cellar", "--door", "cottage.front=0", "--door", "inn.front=0", "--screenshots", "pictures",
                      "--record", "walk", *self.WORLD, size="192x108", step="0.08") as view:
            self.hands = Hands(self.display)
            began = view.state["frames"]  # frames of the loading page are not part of the walk
            self.ask("mousemove", "100", "50")
            self.hands.button(True)  # drags for the whole walk
            view.until(lambda s: s["on_ground"], "it stands")
            self.picture(view)
            cellar = view.state["root"]
            self.walk(view, points[:ground])
            self.assertNotEqual(view.state["root"], cellar)
            self.picture(view)
            self.walk(view, points[ground:out])
            self.assertEqual(view.state["root"], "outside")
            self.assertEqual(self.opened, ["cottage.front"])
            self.picture(view)
            self.walk(view, points[out:inn])
            self.assertEqual(self.opened, ["cottage.front", "inn.front"])
            self.assertNotEqual(view.state["root"], "outside")
            self.picture(view)
            self.walk(view, points[inn:])
            self.assertEqual(view.state["root"], "outside")
            self.assertGreater(view.state["eye"][2], points[inn][2] + 1.0)
            self.hands.tap("r")
            view.until(lambda s: s["weather"] == "rain", "rain")
            self.picture(view)
            self.walk(view, points[inn:][::-1])
            self.hands.key("Shift_L", True)
            self.walk(view, points[out:inn][::-1])
            self.hands.key("Shift_L", False)
            self.assertEqual(view.state["root"], "outside")
            self.picture(view)
            self.walk(view, points[ground:out][::-1])
            self.assertNotEqual(view.state["root"], "outside")
            self.picture(view)
            self.hands.button(False)
            self.hands.close()
            frames = view.latest()["frames"] - began
            self.assertEqual(view.leave(), (0, ""))
        self.keep()
        self.assertEqual(len([name for name in os.listdir(self.path("pictures")) if name.endswith(".png")]), 7)
        self.plays_again(frames)

    def keep(self):
        if "LIMEN_WALK_KEEP" in os.environ:
            shutil.copytree(self.work.name, os.environ["LIMEN_WALK_KEEP"], dirs_exist_ok=True)

    def plays_again(self, frames):
        """Replays every frame and compares its decisions with the window's: eye, root, visits, dynamic state."""
        with open(self.path("walk")) as walk:
            self.assertGreaterEqual(len(walk.readlines()), frames)
        again = subprocess.run([PROGRAM, "probe", "--walk", "walk", *self.WORLD], env=self.env, cwd=self.work.name, capture_output=True, text=True, timeout=240)
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        roots = [json.loads(line) for line in again.stdout.splitlines()]
        self.assertLessEqual(self.roots, {event["root"] for event in roots if event["event"] == "root"})


if __name__ == "__main__":
    unittest.main()
