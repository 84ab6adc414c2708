"""The verbs of the zip for Windows, compared with the program for Linux.

Usage: WineTest.py ZIP LIMEN CACHE [unittest arguments]. ZIP: made by tools/make-windows-zip. LIMEN: the program of the same
sources for Linux. CACHE: a directory for LIMEN's built-in world.
"""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import unittest
import zipfile

from WineDriver import ODD, SECONDS, SOURCES, USER, Wine, png_pixels

Wine.zip = sys.argv.pop(1)
LIMEN, CACHE = os.path.abspath(sys.argv.pop(1)), os.path.abspath(sys.argv.pop(1))
ROOT = SOURCES.resolve().parent.parent
VIEW = ["--at", "inn.hall", "--size", "320x180"]
ROWS = """INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`, `last_Modified`) VALUES (5, 'door', 19, '2020');
INSERT INTO `weenie_properties_string` (`object_Id`, `type`, `value`) VALUES (5, 1, 'Дверь für alle');
INSERT INTO `landblock_instance` (`guid`, `weenie_Class_Id`, `obj_Cell_Id`, `origin_X`, `origin_Y`, `origin_Z`, `angles_W`, `angles_X`,
`angles_Y`, `angles_Z`, `is_Link_Child`, `last_Modified`) VALUES (1, 5, 0xA9B40001, 1, 1, 50, 1, 0, 0, 0, False, '2020');
"""


class WineVerbs(Wine):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.linux = dict(os.environ, XDG_CACHE_HOME=CACHE)
        cls.linux.pop("DISPLAY", None)

    def limen(self, *arguments, code=0, stream=None):
        """Runs limen.exe in the odd directory. Returns the bytes of its standard output, or the text of its standard error."""
        done = subprocess.run(["wine", self.program, *arguments], env=self.env, cwd=self.work, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, code, done.stderr.decode(errors="replace") + done.stdout.decode(errors="replace")[-2000:])
        return done.stderr.decode() if stream == "stderr" else done.stdout

    def on_linux(self, *arguments):
        """Runs the program for Linux in a directory of its own. Returns its standard output."""
        done = subprocess.run([LIMEN, *arguments], env=self.linux, cwd=self.root, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 0, done.stderr.decode(errors="replace"))
        return done.stdout

    def test_doctor_finds_nothing_that_fails(self):
        report = json.loads(self.limen("doctor", "--json"))
        outcomes = {check["check"]: check for check in report["checks"]}
        self.assertEqual([check for check in report["checks"] if check["result"] == "failed"], [])
        self.assertIn("4.5", outcomes["OpenGL driver"]["finding"])
        for name, text in (("display", "Windows"), ("font", ODD), ("cache", USER + "\\AppData\\Local\\limen\\cache"),
                           ("settings", USER + "\\AppData\\Roaming\\limen")):
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
        self.limen("shot", *VIEW, "-o", f"neu/{name}", "--json", "отчёт.json", code=2)  # the directory is missing
        wrote = self.limen("shot", *VIEW, "-o", name, "--json", "отчёт.json", stream="stderr")
        self.assertIn(f"{ODD}\\{name}", wrote)
        self.assertTrue((self.work / name).is_file())
        self.assertIn("visits", json.loads((self.work / "отчёт.json").read_bytes()))
        views = self.work / "Ansichten да.txt"
        views.write_text("--at hill -o Hügel.png\n--at inn.hall -o зал.png\n", encoding="utf-8")
        self.limen("shot", "--views", views.name, "-o", "Bilder да", "--size", "64x36")
        self.assertEqual(len(list((self.work / "Bilder да").glob("*.png"))), 2)

    def test_a_world_in_a_directory_with_letters_of_any_language(self):
        self.limen("demo", "eigene Welt мир")
        for directory in ("eigene Welt мир", self.windows_path(self.work / "eigene Welt мир")):
            self.assertIn(b"inn.hall", self.limen("places", "--dat", directory))
        report = json.loads(self.limen("doctor", "eigene Welt мир", "--json"))
        self.assertIn("eigene Welt мир", [check["finding"] for check in report["checks"] if check["check"] == "files"][0])
        self.limen("dat", "export", "0xA9B40100", "--as", "gltf", "--dat", "eigene Welt мир", "-o", "Modelle ж")
        self.assertEqual(len(list((self.work / "Modelle ж").glob("*.glb"))), 1)
        missing = self.limen("places", "--dat", "eigene Wält мир", code=2, stream="stderr")
        self.assertIn("has no 'eigene Wält мир'", missing)
        self.assertIn('--dat "C:\\Turbine\\Asheron\'s Call"', missing)

    def test_a_name_that_is_no_utf8_gets_a_replacement_character(self):
        (self.work / "alt.txt").write_bytes(b"--at hill -o H\xfcgel.png\n")  # in the code page 1252
        self.limen("shot", "--views", "alt.txt", "-o", "alt", "--size", "64x36")
        self.assertEqual([path.name for path in (self.work / "alt").glob("*.png")], ["H\N{REPLACEMENT CHARACTER}gel.png"])

    def test_half_of_a_surrogate_pair_is_one_clear_line(self):
        """Such a name cannot be text. Wine cannot make a file of such a name, but can hand it over as an argument."""
        helper = self.work / "half.exe"
        self.compile("HalfPair.c", helper)
        for command in (["places", "--dat", "w?lt"], ["shot", *VIEW, "-o", "h?lbe.png"], ["dat", "verify", "a?.dat"]):
            done = subprocess.run(["wine", helper, self.windows_path(self.program), *command], env=self.env, cwd=self.work,
                                  capture_output=True, timeout=SECONDS, check=False)
            message = done.stderr.decode()
            self.assertEqual((done.returncode, done.stdout, message.count("\n")), (2, b"", 1), message)
            self.assertIn("'" + command[-1].replace("?", "\N{REPLACEMENT CHARACTER}") + "'", message)
            self.assertIn("half of a surrogate pair", message)
        self.assertEqual(list(self.work.glob("h*lbe.png")), [])

    def test_names_that_can_be_text(self):
        program = self.work / "wellformed.exe"
        platform = ROOT / "src/core/platform/windows"
        subprocess.run(["x86_64-w64-mingw32-g++-posix", "-std=c++20", "-static", "-DNOMINMAX", "-D_WIN32_WINNT=0x0A00", f"-I{ROOT}/src",
                        SOURCES / "WellFormedTest.cpp", *(platform / f"{name}.cpp" for name in ("Files", "Process", "Text")),
                        ROOT / "src/core/Error.cpp", ROOT / "src/core/Assert.cpp", "-o", program], check=True)
        done = subprocess.run(["wine", program], env=self.env, capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, b""))

    def test_placed_objects_come_from_an_archive_and_a_database_with_odd_names(self):
        with zipfile.ZipFile(self.work / "Städte мир.zip", "w") as archive:
            archive.writestr("Tür/дверь.sql", ROWS)
        self.limen("world", "import", "Städte мир.zip", "-o", "Ørter мир.db")
        listed = self.limen("world", "list", "--dat", "Ørter мир.db", "--json").decode()
        self.assertIn("Дверь für alle", listed)
        self.assertEqual(listed, self.on_linux_in(self.work, "world", "list", "--dat", "Ørter мир.db", "--json").decode())

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

    def test_two_threads_draw_for_a_check(self):
        command = ["check", "--views", "400", "--seed", "9", "--size", "64x36", "--json"]
        self.assertEqual(json.loads(self.limen(*command))["pictures_hash"], json.loads(self.on_linux(*command))["pictures_hash"])

    def test_a_film_goes_through_ffmpeg(self):
        tools = self.work / "Werkzeuge да"
        tools.mkdir()
        self.compile("FakeFfmpeg.c", tools / "ffmpeg.exe")
        environment = dict(self.env, WINEPATH=self.windows_path(tools))
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


if __name__ == "__main__":
    unittest.main()
