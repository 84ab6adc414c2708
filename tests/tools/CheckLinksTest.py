"""CheckLinksTest.py SOURCE: tools/check-links finds each kind of broken link, and accepts a whole site."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1))
GOOD = '<h1 id="top">A</h1><a name="old"></a><a href="b%20c.html#part">b</a><a href="#old">o</a><a href="https://x.invalid/y">x</a><img src="p.png">'


class CheckLinks(unittest.TestCase):
    def check(self, index):
        with tempfile.TemporaryDirectory() as folder:
            site = pathlib.Path(folder) / "site"
            site.mkdir()
            (site / "p.png").touch()
            (site.parent / "outside.html").touch()
            (site / "b c.html").write_text('<p id="part"><a href="index.html#top">a</a></p>')
            if index is not None:
                (site / "index.html").write_text(index)
            else:
                (site / "b c.html").unlink()
            done = subprocess.run([SOURCE / "tools/check-links", site], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def test_accepts_a_whole_site(self):
        self.assertEqual(self.check(GOOD), (0, "5 links on 2 pages, 0 broken\n"))

    def test_finds_broken_links(self):
        for link, fault in (("c.html", "no such file"), ("b%20c.html#other", "no such heading"), ("#other", "no such heading"),
                            ("../outside.html", "leads out of the site"), ("#nested-classes", "no such heading")):
            status, printed = self.check(f'{GOOD}\n<a href="{link}">c</a>')
            self.assertEqual(status, 1, link)
            self.assertIn(f"index.html:2: {link}: ", printed)
            self.assertIn(fault, printed)

    def test_needs_pages(self):
        self.assertEqual(self.check(None)[0], 2)


unittest.main()
