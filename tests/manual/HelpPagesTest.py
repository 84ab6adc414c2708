"""Manual pages, completions and help texts of the built program, read by the programs that they are made for.

Arguments: the program, a cache directory, the source tree."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, CACHE, SOURCE = (os.path.abspath(argument) for argument in sys.argv[1:4])
ENVIRONMENT = dict(os.environ, XDG_CACHE_HOME=CACHE, PATH=f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}")


def limen(*arguments):
    return subprocess.run([PROGRAM, *arguments], env=ENVIRONMENT, capture_output=True, text=True, check=True).stdout


def verbs_below(*path):
    page = limen("help", *path)
    if "\nVerbs:\n" not in page:
        return []
    rows = page.split("\nVerbs:\n")[1].split("\n\n")[0].split("\n")
    return [(*path, row.split()[0]) for row in rows if row.startswith("  ") and not row.startswith("   ")]


def all_commands():
    commands, waiting = [], [()]
    while waiting:
        path = waiting.pop(0)
        commands.append(path)
        waiting += verbs_below(*path)
    return commands


class ManPagesTest(unittest.TestCase):
    def test_every_page_is_sound(self):
        with tempfile.TemporaryDirectory() as pages:
            limen("man", "-o", pages)
            files = sorted(pathlib.Path(pages).glob("*.1"))
            self.assertEqual({file.stem for file in files}, {"-".join(("limen", *path)) for path in all_commands()})
            lint = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", *files], capture_output=True, text=True)
            # A page without a date is a warning of mandoc; a date would make the pages depend on the day.
            faults = [line for line in lint.stdout.split("\n") if line and "missing date" not in line]
            self.assertEqual(faults, [])

    def test_a_page_reads_well(self):
        page = subprocess.run(["mandoc", "-T", "utf8"], input=limen("man", "shot"), capture_output=True, text=True, check=True).stdout
        plain = re.sub(".\b", "", page)  # overstruck letters
        self.assertIn("LIMEN-SHOT(1)", plain)
        self.assertIn("--size WxH", plain)
        self.assertIn("limen shot --at hill -o hill.png", plain)


class BashTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.script = limen("completions", "bash")

    def complete(self, line):
        """The replies for the last word of a line, cut as bash cuts it."""
        script = self.script + r'''
        _get() { COMP_LINE=$1; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _limen; printf '%s\n' "${COMPREPLY[@]}"; }
        _get "$@"
        '''
        words = line.split(" ")
        run = subprocess.run(["bash", "--norc", "-c", script, "test", line, *words], capture_output=True, text=True, cwd=SOURCE)
        self.assertEqual(run.stderr, "")
        return run.stdout.split()

    def test_verbs(self):
        self.assertIn("shot", self.complete("limen "))
        self.assertEqual(self.complete("limen sh"), ["shot"])
        self.assertEqual(self.complete("limen dat v"), ["verify"])
        self.assertEqual(self.complete("limen help sh"), ["shot"])

    def test_options(self):
        self.assertEqual(self.complete("limen shot --wea"), ["--weather"])
        self.assertIn("--kinds", self.complete("limen check --"))
        self.assertNotIn("--kinds", self.complete("limen shot --"))

    def test_values(self):
        self.assertEqual(self.complete("limen shot --weather "), ["clear", "rain"])
        self.assertEqual(self.complete("limen shot --weather = r"), ["rain"])
        self.assertEqual(self.complete("limen demo --kind to"), ["town"])
        self.assertEqual(self.complete("limen completions z"), ["zsh"])
        self.assertIn("inn.hall", self.complete("limen shot --at inn"))

    def test_files_and_directories(self):
        self.assertEqual(self.complete("limen shot --dat sr"), ["src"])
        self.assertEqual(self.complete("limen shot --dat READ"), [])
        self.assertEqual(self.complete("limen tour --path READ"), ["README.md"])

    def test_it_registers_itself(self):
        run = subprocess.run(["bash", "--norc", "-c", self.script + "\ncomplete -p limen"], capture_output=True, text=True)
        self.assertIn("-F _limen limen", run.stdout)


class ZshTest(unittest.TestCase):
    def setUp(self):
        self.work = tempfile.TemporaryDirectory()
        self.file = os.path.join(self.work.name, "_limen")
        limen("completions", "zsh", "-o", self.file)

    def tearDown(self):
        self.work.cleanup()

    def zsh(self, script):
        run = subprocess.run(["zsh", "-f", "-c", script], capture_output=True, text=True, env=dict(ENVIRONMENT, HOME=self.work.name), timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def test_the_file_has_no_error(self):
        self.zsh(f"zsh -n {self.file}")

    def test_it_is_found_in_fpath(self):
        out = self.zsh(f"fpath=({self.work.name} $fpath); autoload -Uz compinit; compinit -u -D; print $_comps[limen]")
        self.assertEqual(out.strip(), "_limen")

    def test_it_completes_at_a_prompt(self):
        script = f"""
        zmodload zsh/zpty
        zpty shell zsh -f -i
        zpty -w shell 'PROMPT=; fpath=({self.work.name} $fpath); autoload -Uz compinit; compinit -u -D; bindkey "^I" complete-word; print rea""dy'
        line=; until [[ $line == *ready* ]]; do zpty -r shell line || exit 1; done
        zpty -w -n shell $'limen shot --weat\\t' ; sleep 1
        zpty -w -n shell $' r\\t#\\n'
        all=; until [[ $all == *'#'* ]]; do zpty -r shell line || break; all+=$line; done
        print -r -- $all
        zpty -d shell
        """
        out = self.zsh(script)
        self.assertIn("--weather", out)
        self.assertIn("rain", out)


class HelpTest(unittest.TestCase):
    def test_every_page_ends_with_two_examples(self):
        for path in all_commands():
            page = limen("help", *path)
            self.assertIn("\nExamples:\n", page, path)
            examples = page.split("\nExamples:\n")[1].rstrip().split("\n")
            self.assertEqual(len([line for line in examples if line.startswith("  limen")]), 2, path)

    def test_help_and_the_option_agree(self):
        for path in [(), ("shot",), ("dat", "ls")]:
            self.assertEqual(limen("help", *path), limen(*path, "--help"))

    def test_lines_are_short(self):
        for path in all_commands():
            for line in limen("help", *path).split("\n"):
                self.assertLessEqual(len(line), 110, line)

    def test_every_option_says_what_happens_without_it(self):
        """A flag is off by default, a required option has no default; every other option names its default."""
        for path in all_commands():
            text = limen("man", *path).replace("\\-", "-").replace("\\fB", "").replace("\\fR", "")
            for entry in text.split(".SH NOTES")[0].split(".TP\n")[1:]:
                head, _, body = entry.partition("\n")
                takes_value = "\\fI" in head and head.startswith("-")
                if takes_value:
                    self.assertIn("(", body, f"{path}: {head} names no default")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
