"""The zip for Windows, under Wine with Mesa's software OpenGL on a display of its own.

Usage: WineTest.py ZIP LIMEN CACHE [unittest arguments]. ZIP: made by tools/make-windows-zip. LIMEN: the program of the same
sources for Linux. CACHE: a directory for LIMEN's built-in world.
"""

import hashlib
import json
import os
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading
import unittest
import zipfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "viewer"))
from WindowDriver import png_pixels, start_server  # noqa: E402

ZIP, LIMEN, CACHE = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
ODD = "für die Дом files"  # a space, an umlaut and Cyrillic letters
VIEW = ["--at", "inn.hall", "--size", "320x180"]
SECONDS = 1500  # limit of a command


class Wine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name)
        cls.server, display = start_server("1024x768x24")
        cls.linux = dict(os.environ, XDG_CACHE_HOME=CACHE)
        cls.linux.pop("DISPLAY", None)
        cls.env = dict(os.environ, DISPLAY=display, WINEPREFIX=str(cls.root / "prefix"), WINEDEBUG="-all", HOME=str(cls.root),
                       WINEDLLOVERRIDES="mscoree,mshtml=", LC_ALL="C.UTF-8")
        subprocess.run(["wine", "wineboot", "-i"], env=cls.env, check=True, timeout=SECONDS, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.work = cls.root / ODD
        with zipfile.ZipFile(ZIP) as archive:
            archive.extractall(cls.work)
        cls.program, = cls.work.glob("*/limen.exe")

    @classmethod
    def tearDownClass(cls):
        subprocess.run(["wineserver", "-k"], env=cls.env, check=False)
        cls.server.kill()
        cls.server.wait()
        cls.folder.cleanup()

    def limen(self, *arguments, code=0):
        """Runs limen.exe in the odd directory. Returns its standard output."""
        done = subprocess.run(["wine", self.program, *arguments], env=self.env, cwd=self.work, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, code, done.stderr.decode(errors="replace") + done.stdout.decode(errors="replace")[-2000:])
        return done.stdout

    def on_linux(self, *arguments):
        """Runs the program for Linux in a directory of its own. Returns its standard output."""
        done = subprocess.run([LIMEN, *arguments], env=self.linux, cwd=self.root, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 0, done.stderr.decode(errors="replace"))
        return done.stdout

    def user_directory(self, name):
        """A directory below the user's AppData, as Windows names it."""
        found = list((self.root / "prefix" / "drive_c" / "users").glob(f"*/AppData/{name}/limen"))
        self.assertEqual(len(found), 1, name)
        return found[0]

    def test_doctor_finds_nothing_that_fails(self):
        report = json.loads(self.limen("doctor", "--json"))
        outcomes = {check["check"]: check for check in report["checks"]}
        self.assertEqual([check for check in report["checks"] if check["result"] == "failed"], [])
        self.assertIn("4.5", outcomes["OpenGL driver"]["finding"])
        for name, text in (("display", "Windows"), ("font", "DejaVuSans.ttf"), ("cache", "AppData\\Local\\limen\\cache"),
                           ("settings", "AppData\\Roaming\\limen")):
            self.assertEqual(outcomes[name]["result"], "ok", outcomes[name])
            self.assertIn(text, outcomes[name]["finding"])

    def test_the_built_in_world_has_the_same_cells_and_places(self):
        """The models of the portal file are made with functions that round differently (decision 186): 6,459 bytes differ."""
        self.limen("places")
        self.on_linux("places")
        ours = self.files_of(next((self.user_directory("Local") / "cache").glob("*/client_portal.dat")).parent)
        linux = self.files_of(max(pathlib.Path(CACHE, "limen").glob("*/client_portal.dat"), key=lambda path: path.stat().st_mtime).parent)
        self.assertEqual(ours, linux)

    @staticmethod
    def files_of(directory):
        """By name: the hash of a file, but the size of the portal file."""
        return {path.name: path.stat().st_size if path.name == "client_portal.dat" else hashlib.sha256(path.read_bytes()).hexdigest()
                for path in directory.iterdir() if path.is_file()}

    def test_a_picture_its_ids_and_its_depth_are_those_of_linux(self):
        outputs = ["-o", "bild.png", "--ids", "ids.npy", "--depth", "depth.npy"]
        self.limen("shot", *VIEW, *outputs)
        self.on_linux("shot", *VIEW, *outputs)
        for name in ("ids.npy", "depth.npy", "bild.png"):
            self.assertEqual((self.work / name).read_bytes(), (self.root / name).read_bytes(), name)
        self.assertGreater(len(set(png_pixels(self.work / "bild.png")[2])), 50)

    def test_names_with_letters_of_any_language(self):
        name = "Straße und дорога.png"
        shown = self.limen("shot", *VIEW, "-o", f"neu/{name}", "--json", "отчёт.json", code=2)  # the directory is missing
        self.assertEqual(shown, b"")
        self.limen("shot", *VIEW, "-o", name, "--json", "отчёт.json")
        self.assertTrue((self.work / name).is_file())
        self.assertIn("visits", json.loads((self.work / "отчёт.json").read_bytes()))
        self.limen("demo", "eigene Welt мир")
        self.assertIn(b"inn.hall", self.limen("places", "--dat", "eigene Welt мир"))

    def test_dat_verify_reads_every_record(self):
        self.limen("demo", "verify")
        self.assertEqual(self.limen("dat", "verify", "verify"), self.on_linux_in(self.work, "dat", "verify", "verify"))

    def on_linux_in(self, folder, *arguments):
        return subprocess.run([LIMEN, *arguments], env=self.linux, cwd=folder, capture_output=True, timeout=SECONDS, check=True).stdout

    def test_check_has_the_result_of_linux(self):
        command = ["check", "--views", "50", "--seed", "9", "--json"]
        ours, linux = json.loads(self.limen(*command)), json.loads(self.on_linux(*command))
        self.assertEqual(ours["pictures_hash"], linux["pictures_hash"])
        self.assertEqual([key for key in ours if "second" not in key and ours[key] != linux[key]], [])
        self.assertEqual(ours["disagreeing_pixels"], 0)

    def test_a_film_goes_through_ffmpeg(self):
        source = pathlib.Path(__file__).with_name("FakeFfmpeg.c")
        tools = self.work / "Werkzeuge да"
        tools.mkdir()
        subprocess.run(["x86_64-w64-mingw32-gcc-posix", "-municode", source, "-o", tools / "ffmpeg.exe"], check=True)
        environment = dict(self.env, WINEPATH="Z:" + str(tools).replace("/", "\\"))
        done = subprocess.run(["wine", self.program, "tour", "--frames", "3", "--size", "64x36", "--film", "Фильм.gif"], env=environment,
                              cwd=self.work, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 0, done.stderr.decode(errors="replace"))
        self.assertEqual((self.work / "Фильм.gif").stat().st_size, 3 * 64 * 36 * 3)
        self.assertEqual(list(self.work.glob(".limen-film*")), [])

    def test_a_database_server_is_refused_in_one_line(self):
        done = subprocess.run(["wine", self.program, "world", "import", "mysql://me@localhost/world", "-o", "world.db"], env=self.env,
                              cwd=self.work, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.decode().count("\n"), 1, done.stderr)
        self.assertIn("MariaDB", done.stderr.decode())

    def test_the_window_takes_keys(self):
        view = subprocess.Popen(["wine", self.program, "view", "--size", "480x270", "--at", "hill", "--fly", "--tell", "--step", "0.0333"],
                                env=self.env, cwd=self.work, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, encoding="utf-8")
        states = queue.Queue()
        reader = threading.Thread(target=lambda: [states.put(json.loads(line)) for line in view.stdout], daemon=True)
        reader.start()
        try:
            self.drive_window(states)
        finally:
            subprocess.run(["wineserver", "-k"], env=self.env, check=False)
            view.wait()
            reader.join(10)
            view.stdout.close()

    def until(self, states, holds):
        for _ in range(3000):
            state = states.get(timeout=300)
            if holds(state):
                return state
        return self.fail("the state did not come")

    def drive_window(self, states):
        start = self.until(states, lambda state: "eye" in state)

        def xdotool(*arguments):
            return subprocess.run(["xdotool", *arguments], env=self.env, capture_output=True, text=True, check=True, timeout=300).stdout

        window = xdotool("search", "--sync", "--onlyvisible", "--name", "Limen").split()[-1]
        xdotool("windowfocus", window)
        xdotool("keydown", "w")
        self.until(states, lambda state: "eye" in state and sum((a - b) ** 2 for a, b in zip(state["eye"], start["eye"])) > 1.0)
        xdotool("keyup", "w")
        xdotool("key", "F12")
        self.until(states, lambda _: list(self.work.glob("limen-*.png")))
        picture, = self.work.glob("limen-*.png")
        self.assertEqual(png_pixels(picture)[:2], (480, 270))
        xdotool("key", "Escape")
        self.until(states, lambda state: state.get("page") == "menu")


if __name__ == "__main__":
    unittest.main()
