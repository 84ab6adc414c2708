"""Runs every example of README.md and docs/manual/*.md. Arguments: the program, a cache directory, the source tree."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import Examples

PROGRAM, CACHE, SOURCE = (os.path.abspath(argument) for argument in sys.argv[1:4])
PAGES = [pathlib.Path(SOURCE, "README.md"), *sorted(pathlib.Path(SOURCE, "docs", "manual").glob("*.md"))]


def examples_of(page):
    return Examples.examples(os.path.relpath(page, SOURCE), page.read_text())


class ExamplesTest(unittest.TestCase):
    """The examples of a page run in order, in a directory of their own: one may use the files of another."""

    def run_page(self, page):
        with tempfile.TemporaryDirectory() as work:
            tools = pathlib.Path(work, "bin")
            tools.mkdir()
            (tools / "limen").symlink_to(PROGRAM)
            environment = dict(os.environ, XDG_CACHE_HOME=CACHE, PATH=f"{tools}:{os.environ['PATH']}")
            environment.pop("DISPLAY", None)
            environment.pop("WAYLAND_DISPLAY", None)
            for example in examples_of(page):
                if example.not_run:
                    print(f"not run: {example} ({example.not_run})", file=sys.stderr)
                    continue
                with self.subTest(str(example)):
                    run = subprocess.run(["bash", "-c", example.command], cwd=work, env=environment, text=True,
                                         capture_output=True, stdin=subprocess.DEVNULL, timeout=120)
                    self.assertEqual(run.returncode, example.exit, f"{example}\n{run.stdout[-2000:]}{run.stderr[-2000:]}")

    def test_every_example_does_as_it_says(self):
        for page in PAGES:
            self.run_page(page)

    def test_the_manual_has_examples(self):
        count = sum(not example.not_run for page in PAGES for example in examples_of(page))
        self.assertGreater(count, 20, "too few examples found for the test to mean anything")

    def test_every_verb_has_an_example(self):
        verbs = pathlib.Path(SOURCE, "docs", "manual", "verbs.md").read_text()
        listed = subprocess.run([PROGRAM, "help"], capture_output=True, text=True, check=True).stdout
        names = [line.split()[0] for line in listed.split("Verbs:\n")[1].split("\n\n")[0].split("\n")
                 if line.startswith("  ") and not line.startswith("   ")]
        self.assertGreater(len(names), 8)
        for name in names:
            self.assertIn(f"limen {name}", verbs, f"docs/manual/verbs.md does not show the verb {name}")


class FindingTest(unittest.TestCase):
    """The search itself."""

    def found(self, text):
        return [(e.command, e.exit, e.not_run) for e in Examples.examples("page", text)]

    def test_finds_fenced_and_indented_commands(self):
        text = "A\n\n```sh\nlimen dat ls   # lists\n# a comment\nlimen dat \\\n    verify\n```\n\n    ./run demo w\n    cmake x\n"
        self.assertEqual(self.found(text), [("limen dat ls", 0, ""), ("limen dat verify", 0, ""), ("limen demo w", 0, "")])

    def test_reads_exit_codes_and_reasons(self):
        text = "```sh\nlimen shto  # exit 2\n```\n<!-- not run: takes an hour -->\n```sh\nlimen bench\n```\n```sh\nlimen man\n```\n"
        self.assertEqual(self.found(text), [("limen shto", 2, ""), ("limen bench", 0, "takes an hour"), ("limen man", 0, "")])

    def test_leaves_placeholders_and_windows_out(self):
        text = "```sh\nlimen tour --dat DIR\nlimen view\nlimen\nlimen shot --at '0xA9B40031 [1 2 3]' -o a\n```\n```\nlimen output\n```\n"
        reasons = [example[2] for example in self.found(text)]
        self.assertEqual([bool(reason) for reason in reasons], [True, True, True, False])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
