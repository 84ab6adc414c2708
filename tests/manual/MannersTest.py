"""The program at a terminal: progress, Ctrl-C, whole files, the window without a verb.

Arguments: the program, a cache directory, the source tree."""

import os
import pathlib
import pty
import select
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, CACHE, SOURCE = (os.path.abspath(argument) for argument in sys.argv[1:4])
ENVIRONMENT = dict(os.environ, XDG_CACHE_HOME=CACHE)
for name in ("DISPLAY", "WAYLAND_DISPLAY"):
    ENVIRONMENT.pop(name, None)
QUICK_CHECK = ["check", "--views", "4000", "--kinds", "random", "--size", "64x36"]


class Manners(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.work = pathlib.Path(self.directory.name)

    def tearDown(self):
        self.directory.cleanup()

    def run_limen(self, *arguments, **environment):
        return subprocess.run([PROGRAM, *arguments], cwd=self.work, env=dict(ENVIRONMENT, **environment),
                              capture_output=True, text=True, timeout=120)

    def start(self, *arguments, **streams):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.work, env=ENVIRONMENT, text=True,
                                **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **streams})

    def on_terminal(self, *arguments, seconds=240, until=None):
        """Standard error on a terminal: the exit code and the text. Sends SIGINT when `until` appears. `seconds` only ends a
        test of a program that hangs: beside three other programs the map has taken a minute."""
        ours, theirs = pty.openpty()
        process = self.start(*arguments, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        text, deadline = "", time.monotonic() + seconds
        while time.monotonic() < deadline:
            ready, _, _ = select.select([ours], [], [], 0.2)
            if ready:
                try:
                    text += os.read(ours, 4096).decode()
                except OSError:  # the other end is closed
                    break
            if until and until in text:
                process.send_signal(signal.SIGINT)
                until = None
        os.close(ours)
        return process.wait(timeout=20), text

    def wait_for(self, condition, seconds=60):
        deadline = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), deadline, "waited too long")
            time.sleep(0.05)


class WithoutAVerb(Manners):
    def test_help_without_a_display(self):
        run = self.run_limen()
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn("Usage: limen", run.stdout)

    def test_the_window_with_a_display(self):
        run = self.run_limen(DISPLAY=":987654")  # there is no such server, so the window fails to open
        self.assertEqual(run.returncode, 2)
        self.assertIn("display", run.stderr)


class Interrupted(Manners):
    def left_over(self):
        return [str(path) for path in self.work.rglob("*") if path.name.endswith((".tmp", ".part")) or path.name.startswith(".")]

    def test_a_check_stops_between_views_and_continues(self):
        process = self.start(*QUICK_CHECK, "--resume", "state", "-o", "findings")
        self.wait_for(lambda: (self.work / "state").exists())  # some views are judged
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGINT, err)
        self.assertIn("stopped after", err)
        self.assertIn("continues", err)
        judged = int(err.split("stopped after ")[1].split()[0])
        self.assertGreater(judged, 0)
        self.assertLess(judged, 4000)
        self.assertEqual(self.left_over(), [])
        again = self.start(*QUICK_CHECK, "--resume", "state", "--json")
        time.sleep(0.5)
        again.send_signal(signal.SIGTERM)
        again.communicate(timeout=60)
        self.assertEqual(again.returncode, -signal.SIGTERM)

    def test_a_tour_keeps_whole_frames(self):
        process = self.start("tour", "-o", "tour", "--frames", "5000", "--size", "64x36")
        self.wait_for(lambda: len(list(self.work.glob("tour/frame-*.png"))) > 3)
        process.send_signal(signal.SIGTERM)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGTERM, err)
        self.assertIn("of 5000 frames", err)
        self.assertEqual(self.left_over(), [])
        for frame in self.work.glob("tour/*.png"):
            self.assertTrue(frame.read_bytes().endswith(b"IEND\xaeB`\x82"), frame)

    def test_a_probe_says_how_far_it_came(self):
        process = self.start("probe", "--frames", "100000", "--size", "64x36")
        process.stdout.readline()
        process.send_signal(signal.SIGHUP)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGHUP)
        self.assertRegex(err, "stopped after [0-9]+ of 100000 frames")

    def test_a_shell_sees_130(self):
        shell = subprocess.run(["bash", "-c", f"{PROGRAM} probe --frames 100000 --size 64x36 >/dev/null 2>&1 & sleep 1; kill -TERM $!; wait $!; echo $?"],
                               env=ENVIRONMENT, capture_output=True, text=True, timeout=60)
        self.assertEqual(shell.stdout.strip(), "143")


class Terminal(Manners):
    def test_progress_and_ctrl_c(self):
        code, text = self.on_terminal("probe", "--frames", "100000", "--size", "64x36", until="probe [")
        self.assertIn("/100000", text)
        self.assertEqual(code, -signal.SIGINT)
        self.assertIn("stopped after", text)

    def test_a_wait_without_a_count_names_its_step(self):
        code, text = self.on_terminal("demo", "--kind", "map", "--size", "5000", "world")
        self.assertEqual(code, 0, text)
        self.assertIn("writing the world ... 1 s", text)
        self.assertIn("Wrote", text)

    def test_no_progress_in_a_file(self):
        run = self.run_limen("demo", "--kind", "map", "--size", "5000", "world")
        self.assertEqual(run.returncode, 0)
        self.assertNotIn("\r", run.stderr)


class Outputs(Manners):
    def test_every_writing_verb_names_its_files(self):
        (self.work / "path").write_text("--at cottage.front\n--at cottage.room\n")
        for arguments, written in [
                (["shot", "--at", "hill", "--size", "32x18", "-o", "a.png", "--json", "a.json"], ["a.png", "a.json"]),
                (["shot", "--reference", "--at", "hill", "--size", "16x9", "--ids", "ids.npy"], ["ids.npy"]),
                (["tour", "--frames", "2", "--size", "32x18", "-o", "tour"], ["tour"]),
                (["walk", "--path", "path", "-o", "walk"], ["walk"]),
                (["dat", "export", "0x13000000", "-o", "out"], ["out"]),
                (["dat", "export", "0x13000000", "-o", "raw", "--as", "raw"], ["raw"]),
                (["dat", "pack", "raw", "--role", "portal", "-o", "new.dat"], ["new.dat"]),
                (["demo", "world"], ["world"]),
                (["man", "-o", "man"], ["man"]),
                (["completions", "bash", "-o", "complete"], ["complete"])]:
            run = self.run_limen(*arguments)
            self.assertEqual(run.returncode, 0, run.stderr)
            for name in written:
                self.assertIn(f"Wrote {self.work / name}", run.stderr, arguments)
                self.assertTrue((self.work / name).exists())

    def test_a_shot_without_output_is_refused(self):
        run = self.run_limen("shot", "--at", "hill")
        self.assertEqual(run.returncode, 2)
        self.assertIn("-o FILE", run.stderr)

    def test_sizes_beyond_the_memory_are_refused_before_loading(self):
        start = time.monotonic()
        run = self.run_limen("demo", "--kind", "dungeon", "--size", "4294967295", "world")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"--size: .* GB of memory, and .* GB are free")
        self.assertFalse((self.work / "world").exists())
        self.assertLess(time.monotonic() - start, 10)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
