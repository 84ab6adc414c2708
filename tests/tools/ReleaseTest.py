"""ReleaseTest.py SOURCE: tools/release in a repository of its own, with scripts in the place of those that build archives."""
import hashlib
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1))
CHANGES = "# Changelog\n\n## [Unreleased]\n\n- Later.\n\n## [1.2.3] - 2026-12-31\n\n- A door.\n\n## [1.2.2] - 2026-12-01\n\n- A wall.\n"
MAKER = '#!/bin/sh\nmkdir -p "$1"\necho {0} >"$1/{0}"\n'


class Release(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name) / "project"
        (self.root / "tools").mkdir(parents=True)
        shutil.copy(SOURCE / "tools/release", self.root / "tools")
        for name in ("make-debs", "make-archive", "make-windows-zip"):
            (self.root / "tools" / name).write_text(MAKER.format(f"{name}.out"))
            (self.root / "tools" / name).chmod(0o755)
        (self.root / "CMakeLists.txt").write_text("project(limen VERSION 1.2.3 LANGUAGES C CXX)\n")
        self.write("CHANGELOG.md", CHANGES)
        (self.root / ".gitignore").write_text("build/\n")
        self.git("init", "-q")
        self.commit()

    def write(self, name, text):
        (self.root / name).write_text(text)

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=e", *words], cwd=self.root, check=True, capture_output=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "state")

    def release(self, *words):
        return subprocess.run([self.root / "tools/release", *words], capture_output=True, text=True)

    def refused(self, message, *words):
        done = self.release(*words)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(message, done.stderr)
        self.assertFalse((self.root / "build").exists(), "nothing is made")

    def test_makes_archives_checksums_and_changes(self):
        done = self.release("1.2.3")
        self.assertEqual(done.returncode, 0, done.stderr)
        output = self.root / "build/release-1.2.3"
        self.assertEqual((output / "CHANGES.md").read_text(), "## [1.2.3] - 2026-12-31\n\n- A door.\n")
        sums = dict(reversed(line.split("  ")) for line in (output / "SHA256SUMS").read_text().splitlines())
        self.assertEqual(sorted(sums), ["CHANGES.md", "make-archive.out", "make-debs.out", "make-windows-zip.out"])
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256((output / name).read_bytes()).hexdigest(), digest, name)

    def test_the_scripts_that_make_archives_take_a_folder(self):
        """Those of the tests do. A script that ignored the folder would leave its archive out of the release."""
        for name in ("make-debs", "make-archive", "make-windows-zip"):
            script = (SOURCE / "tools" / name).read_text()
            self.assertIn(f"# tools/{name} [DIRECTORY]:", script)
            self.assertIn('mkdir -p "${1:-', script)

    def test_fails_without_an_archive_of_each_kind(self):
        for name in ("make-debs", "make-archive", "make-windows-zip"):
            self.write(f"tools/{name}", '#!/bin/sh\nexit 0\n')
            self.commit()
            done = self.release("1.2.3")
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"tools/{name} wrote nothing", done.stderr)
            shutil.rmtree(self.root / "build")
            self.write(f"tools/{name}", MAKER.format(f"{name}.out"))

    def test_says_that_the_archive_for_windows_is_missing(self):
        (self.root / "tools/make-windows-zip").unlink()
        self.commit()
        done = self.release("1.2.3")
        self.assertEqual(done.returncode, 0)
        self.assertIn("no archive for Windows", done.stderr)

    def test_fails_with_an_archive_that_cannot_be_made(self):
        self.write("tools/make-archive", "#!/bin/sh\nexit 3\n")
        self.commit()
        self.assertEqual(self.release("1.2.3").returncode, 3)
        self.assertFalse((self.root / "build/release-1.2.3/SHA256SUMS").exists())

    def test_refuses_another_version(self):
        self.refused("the project's version is 1.2.3, not 1.2.4", "1.2.4")
        self.refused("'1.2' is no version", "1.2")
        self.refused("VERSION")

    def test_refuses_changes_without_a_commit(self):
        self.write("CMakeLists.txt", "project(limen VERSION 1.2.3 LANGUAGES CXX)\n")
        self.refused(" M CMakeLists.txt", "1.2.3")
        self.commit()
        self.write("new.txt", "")
        self.refused("?? new.txt", "1.2.3")

    def test_refuses_a_changelog_without_the_version(self):
        for text, message in ((CHANGES.replace("1.2.3", "1.2.9"), "no section '## [1.2.3] - DATE'"),
                              (CHANGES.replace("2026-12-31", "soon"), "no date"),
                              (CHANGES.replace("- A door.\n", ""), "lists no change")):
            self.write("CHANGELOG.md", text)
            self.commit()
            self.refused(message, "1.2.3")

    def test_refuses_a_folder_with_files(self):
        self.assertEqual(self.release("1.2.3").returncode, 0)
        self.assertIn("is not empty", self.release("1.2.3").stderr)


unittest.main()
