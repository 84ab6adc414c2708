"""The zip for Windows under Wine, with Mesa's software OpenGL on a display of its own."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "viewer"))
from WindowDriver import png_pixels, start_server  # noqa: E402, F401

ODD = "für die Дом files"  # a space, an umlaut and Cyrillic letters
USER = "Jörg Дом"  # the name of the user's directories
SECONDS = 1500  # limit of a command
SOURCES = pathlib.Path(__file__).parent


class Wine(unittest.TestCase):
    """A user of Windows who has unpacked the zip in an odd directory. `zip`: the file of tools/make-windows-zip."""

    zip = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name)
        cls.server, cls.display = start_server("1024x768x24")
        cls.env = dict(os.environ, DISPLAY=cls.display, WINEPREFIX=str(cls.root / "prefix"), WINEDEBUG="-all", HOME=str(cls.root), USER=USER,
                       WINEDLLOVERRIDES="mscoree,mshtml=", LC_ALL="C.UTF-8")
        cls.wine("wineboot", "-i")
        cls.work = cls.root / ODD
        with zipfile.ZipFile(cls.zip) as archive:
            archive.extractall(cls.work)
        cls.program, = cls.work.glob("*/limen.exe")

    @classmethod
    def tearDownClass(cls):
        cls.end_wine()
        cls.server.kill()
        cls.server.wait()
        cls.folder.cleanup()

    @classmethod
    def wine(cls, *arguments):
        subprocess.run(["wine", *arguments], env=cls.env, check=True, timeout=SECONDS, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    @classmethod
    def end_wine(cls):
        """Ends all programs of the prefix."""
        for option in ("-k", "-w"):
            subprocess.run(["wineserver", option], env=cls.env, check=False, timeout=SECONDS)

    @classmethod
    def compile(cls, source, program):
        subprocess.run(["x86_64-w64-mingw32-gcc-posix", "-municode", SOURCES / source, "-o", program], check=True)

    @staticmethod
    def windows_path(path):
        return "Z:" + str(path).replace("/", "\\")

    def user_directory(self, name):
        """The program's directory below the user's AppData."""
        return self.root / "prefix" / "drive_c" / "users" / USER / "AppData" / name / "limen"
