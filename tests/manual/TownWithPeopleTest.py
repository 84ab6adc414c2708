"""Runs the three commands of README.md that show a town with its doors and people, as they stand there. Their sources are
repositories that the test makes from rows of the built-in world. Arguments: the program, a cache directory, the source tree."""

import json
import math
import os
import pathlib
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, CACHE, SOURCE = (os.path.abspath(argument) for argument in sys.argv[1:4])
sys.path.insert(0, os.path.join(SOURCE, "tests", "viewer"))
import WindowDriver  # noqa: E402

PUBLISHED = "https://github.com/ACEmulator/"


def commands():
    """The lines of the block below the heading "Doors and people"."""
    text = pathlib.Path(SOURCE, "README.md").read_text().split("### Doors and people")[1]
    return re.search(r"```sh\n(.*?)```", text, re.S).group(1).strip().split("\n")


class TownWithPeopleTest(unittest.TestCase):
    def setUp(self):
        self.server, display = WindowDriver.start_server()
        self.addCleanup(self.server.wait)
        self.addCleanup(self.server.kill)
        work = tempfile.TemporaryDirectory()
        self.addCleanup(work.cleanup)
        self.work = pathlib.Path(work.name)
        tools, self.origin, self.here = (self.work / name for name in ("bin", "origin", "here"))
        for directory in (tools, self.origin, self.here):
            directory.mkdir()
        (tools / "limen").symlink_to(PROGRAM)
        identity = {f"GIT_{who}_{what}": "test@localhost" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
        self.environment = dict(
            os.environ, XDG_CACHE_HOME=CACHE, XDG_CONFIG_HOME=str(self.work / "config"), DISPLAY=display, HOME=str(self.work),
            PATH=f"{tools}:{os.environ['PATH']}", GIT_CONFIG_COUNT="1", GIT_CONFIG_KEY_0=f"url.file://{self.origin}/.insteadOf",
            GIT_CONFIG_VALUE_0=PUBLISHED, **identity)
        self.environment.pop("WAYLAND_DISPLAY", None)

    def run_here(self, *command, cwd=None):
        done = subprocess.run(command, cwd=cwd or self.here, env=self.environment, text=True, capture_output=True, timeout=240)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}{done.stderr}")
        return done

    def publish(self, name, fill):
        """A repository in the place of a published one."""
        repository = self.origin / name
        repository.mkdir()
        fill(repository)
        for arguments in (("init", "-q"), ("add", "."), ("commit", "-q", "-m", "rows")):
            self.run_here("git", *arguments, cwd=repository)

    def make_sources(self):
        """The dat files of the built-in world without its world.json, whose objects become the core's files of SQL. The patches
        replace the template of one person, who is then called Holtburg."""
        self.run_here("limen", "demo", "DIR")
        self.run_here("limen", "world", "export", "--dat", "DIR/world.json", "--as", "sql", "-o", str(self.work / "rows"))
        (self.here / "DIR" / "world.json").unlink()
        self.publish("ACE-World-16PY", lambda to: shutil.copytree(self.work / "rows", to / "Database"))

        def patch(to):
            person = next(p for p in sorted((self.work / "rows").rglob("*.sql"))
                          if "9 WeenieDefaults" in str(p) and re.search(r"VALUES \(\d+, '[^']*', 10, ", p.read_text()))
            text = person.read_text()
            renamed = re.sub(r"(weenie_properties_string`.*?VALUES \(\d+, +1, ')[^']*'", r"\1Holtburg'", text, flags=re.S)
            self.assertNotEqual(text, renamed)
            target = to / "Database" / person.relative_to(self.work / "rows")
            target.parent.mkdir(parents=True)
            target.write_text(renamed)
        self.publish("ACE-World-16PY-Patches", patch)

    def test_three_commands_open_a_town_with_doors_and_people(self):
        lines = commands()
        self.assertEqual(len(lines), 3, "the README promises three commands")
        self.assertFalse([line for line in lines if "&&" in line or ";" in line], "each line is one command")
        self.make_sources()
        for line in lines[:2]:
            self.run_here("bash", "-c", line)
        view = subprocess.Popen(["bash", "-c", f"exec {lines[2]}"], cwd=self.here, env=self.environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(view.kill)
        deadline, shown = time.monotonic() + 120, ""
        while time.monotonic() < deadline and not shown and view.poll() is None:
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Limen"], env=self.environment, text=True,
                                   capture_output=True)
            shown = found.stdout.strip()
            time.sleep(0.2)
        self.assertTrue(shown, "no window" if view.poll() is None else view.communicate()[1])
        view.send_signal(signal.SIGTERM)
        _, errors = view.communicate(timeout=120)
        self.assertEqual(view.returncode, 128 + signal.SIGTERM, errors)
        self.assertIn("placed objects", errors)
        with sqlite3.connect(self.here / "DIR" / "world.db") as database:
            joined = "FROM placement p JOIN template t ON t.id = p.template"
            types = dict(database.execute(f"SELECT t.type, COUNT(*) {joined} GROUP BY 1"))
            people = list(database.execute(f"SELECT p.landblock, p.x, p.y {joined} WHERE t.name = 'Holtburg'"))
        self.assertGreater(types.get(19, 0), 5, "doors")
        self.assertGreater(types.get(10, 0), 2, "people")

        self.assertEqual(len(people), 1, "the patch replaced a template of the core")

        # The same once more: nothing to import, and the eye is before the person of that name.
        again = self.run_here("bash", "-c", f"{lines[2]} --frames 3 --size 320x180 --json --screenshot town.png")
        self.assertIn("is up to date", again.stderr)
        state = json.loads(again.stdout)
        landblock, x, y = people[0]
        person = 192 * (landblock >> 8) + x, 192 * (landblock & 255) + y
        self.assertLess(math.dist(state["eye"][:2], person), 3.1, f"{state['eye']} {person}")
        self.assertTrue((self.here / "town.png").stat().st_size > 0)
        picture = os.environ.get("LIMEN_KEEP_PICTURE")
        if picture:
            shutil.copy(self.here / "town.png", picture)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
