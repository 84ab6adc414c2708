"""The zip for Windows as another user, without a network, with a home that cannot be written but for temporary files, under Wine.

Usage: WineOtherUserTest.py ZIP [unittest arguments]. Needs the rights of root, to become that user and to leave the network.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

from WineDriver import ODD, SECONDS, USER, start_server

ZIP = os.path.abspath(sys.argv.pop(1))
OTHER = 65534  # nobody
AS_OTHER = ["unshare", "--net", "setpriv", f"--reuid={OTHER}", f"--regid={OTHER}", "--clear-groups"]


def own(folder):
    """Gives a folder, with all in it, to the other user."""
    for path, folders, files in os.walk(folder):
        for name in (".", *folders, *files):
            os.chown(os.path.join(path, name), OTHER, OTHER, follow_symlinks=False)


class WineOtherUser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="limen für ")
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.root.chmod(0o755)
        server, display = start_server("640x480x24", "-ac")
        cls.addClassCleanup(server.wait)
        cls.addClassCleanup(server.kill)
        cls.env = dict(os.environ, DISPLAY=display, WINEPREFIX=str(cls.root / "prefix"), WINEDEBUG="-all", HOME=str(cls.root / "home"), USER=USER,
                       WINEDLLOVERRIDES="mscoree,mshtml=", LC_ALL="C.UTF-8")
        cls.work = cls.root / ODD
        for path in (cls.root / "prefix", cls.root / "home", cls.work):
            path.mkdir()
        with zipfile.ZipFile(ZIP) as archive:
            archive.extractall(cls.work)
        cls.program, = cls.work.glob("*/limen.exe")
        own(cls.root)
        cls.addClassCleanup(cls.run_wine, "wineserver", "-k")
        cls.run_wine("wine", "wineboot", "-i")
        cls.run_wine("wineserver", "-w")
        cls.take_rights()

    @classmethod
    def run_wine(cls, *command):
        return subprocess.run([*AS_OTHER, *command], env=cls.env, cwd=cls.work, capture_output=True, timeout=SECONDS, check=False)

    @classmethod
    def take_rights(cls):
        """Nothing in the homes of the user can be written, but for %TEMP%."""
        cls.user = cls.root / "prefix/drive_c/users" / USER
        for home in (cls.root / "home", cls.user):
            for path, folders, _ in os.walk(home):
                folders[:] = [name for name in folders if name.lower() != "temp" and not os.path.islink(os.path.join(path, name))]
                os.chmod(path, 0o555)

    def limen(self, *arguments):
        done = self.run_wine("wine", self.program, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr.decode(errors="replace") + done.stdout.decode(errors="replace")[-2000:])
        return done.stdout

    def test_the_home_and_the_network_are_out_of_reach(self):
        for path in (self.user / "AppData/Roaming", self.user / "AppData/Local", self.root / "home"):
            done = self.run_wine("touch", path / "file")
            self.assertNotEqual(done.returncode, 0, path)
        self.assertEqual(self.run_wine("touch", self.user / "Temp/file").returncode, 0)
        done = self.run_wine("bash", "-c", "exec 3<>/dev/tcp/127.0.0.1/80")
        self.assertIn(b"unreachable", done.stderr + done.stdout)

    def test_it_draws_and_checks(self):
        self.limen("shot", "--at", "inn.hall", "--size", "160x90", "-o", "зал für.png")
        self.assertGreater((self.work / "зал für.png").stat().st_size, 5000)
        report = json.loads(self.limen("check", "--views", "5", "--seed", "9", "--json"))
        self.assertEqual(report["disagreeing_pixels"], 0)
        self.assertEqual([path.name for path in (self.user / "AppData").rglob("*") if path.name == "limen"], [])

    def test_the_doctor_names_the_directories_that_cannot_be_written(self):
        report = json.loads(self.run_wine("wine", self.program, "doctor", "--json").stdout)
        found = {check["check"]: check["result"] for check in report["checks"]}
        self.assertEqual((found["OpenGL driver"], found["display"]), ("ok", "ok"), report)
        self.assertNotEqual(found["cache"], "ok", report)
        self.assertNotEqual(found["settings"], "ok", report)


if __name__ == "__main__":
    unittest.main()
