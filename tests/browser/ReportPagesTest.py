#!/usr/bin/env python3
"""The report pages of `limen tour` and `limen check` in a browser. ReportPagesTest.py PROGRAM CACHE [unittest arguments]."""

import html.parser
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from Browser import Browser

VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}


class Nesting(html.parser.HTMLParser):
    """Collects unbalanced elements, doubled ids and pictures without alt text."""

    def __init__(self):
        super().__init__()
        self.open, self.faults, self.ids = [], [], set()

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if "id" in attributes:
            if attributes["id"] in self.ids:
                self.faults.append("id twice: " + attributes["id"])
            self.ids.add(attributes["id"])
        if tag == "img" and "alt" not in attributes:
            self.faults.append("img without alt")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> at {self.getpos()}")


class ReportPages(unittest.TestCase):
    program = cache = None

    @classmethod
    def setUpClass(cls):
        if shutil.which("chromium") is None:
            raise unittest.SkipTest("chromium is not installed")
        cls.work = tempfile.TemporaryDirectory()
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.work.cleanup()

    def limen(self, *arguments, code=0):
        env = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        run = subprocess.run([self.program, *arguments], cwd=self.work.name, capture_output=True, text=True, timeout=200,
                             env=dict(env, XDG_CACHE_HOME=self.cache))
        self.assertEqual(run.returncode, code, run.stderr)
        return run

    def open(self, report, **screen):
        path = os.path.join(self.work.name, report, "index.html")
        self.assertEqual(os.listdir(os.path.dirname(path)), ["index.html"], "one page and nothing beside it")
        self.browser.open(path, **screen)
        with open(path, encoding="utf-8") as file:
            nesting = Nesting()
            nesting.feed(file.read())
        self.assertEqual(nesting.faults + nesting.open, [])

    def expect_quiet(self):
        self.assertEqual(self.browser.errors, [])
        self.assertEqual([r for r in self.browser.requests if not r.startswith(("file:", "data:"))], [])

    def test_a_tour(self):
        self.limen("tour", "--frames", "12", "--size", "96x54", "--report", "tour")
        self.open("tour")
        run = self.browser.run
        self.assertEqual(run("document.querySelectorAll('.strip img').length"), 12)
        self.assertTrue(run("[...document.images].every((i) => i.complete && i.naturalWidth === 96)"))
        plots = run("document.querySelectorAll('svg.plot').length")
        self.assertEqual(plots, run("JSON.parse(byId('data').textContent).plots.length"))
        self.assertGreaterEqual(plots, 3)
        lines = run("JSON.parse(byId('data').textContent).plots.map((p) => p.series.length).reduce((a, b) => a + b)")
        self.assertEqual(run("document.querySelectorAll('svg.plot path[data-series]').length"), lines)
        self.assertTrue(run("[...document.querySelectorAll('svg.plot path')].every((p) => /^M[\\d. LM]+$/.test(p.getAttribute('d')))"))
        self.assertEqual(run("document.querySelectorAll('.graph .node').length"),
                         run("JSON.parse(byId('data').textContent).graph.nodes.length"))
        self.assertGreater(run("document.querySelectorAll('.graph .edge').length"), 0)

        # The scrubber, by keys as a person without a mouse uses it.
        run("byId('frame').focus()")
        for _ in range(3):
            self.browser.press("ArrowRight", virtual=39)
        self.assertEqual(run("byId('number').textContent"), "frame 3")
        self.assertTrue(run("byId('picture').src === document.querySelectorAll('.strip img')[3].src"))
        self.assertEqual(run("document.querySelector('.strip [aria-current]').title"), "Frame 3")
        self.browser.press("End", virtual=35)
        self.assertEqual(run("byId('number').textContent"), "frame 11")
        self.assertTrue(run("byId('command').textContent.startsWith('limen shot ')"))
        roots = run("JSON.parse(byId('data').textContent).graph.frames.map((f) => f[0])")
        self.assertEqual(run("Number(document.querySelector('.graph .node.root').dataset.node)"), roots[11])

        # The mouse: a picture of the strip, a plot, a line's name, a space of the graph.
        self.browser.click(".strip button:nth-child(2)")
        self.assertEqual(run("byId('number').textContent"), "frame 1")
        self.browser.click("svg.plot")
        self.assertIn(run("byId('number').textContent"), ("frame 5", "frame 6"))
        self.browser.click(".legend button")
        self.assertEqual(run("document.querySelectorAll('svg.plot path[data-series]').length"), lines - 1)
        run("(() => { const s = document.querySelector('#graph select'); s.selectedIndex = 1; s.dispatchEvent(new Event('change')); })()")
        self.assertIn("Openings to", run("document.querySelector('.graphinfo').textContent"))
        self.browser.click("#play")
        self.browser.until("byId('play').textContent === 'Pause'")
        self.browser.until("byId('number').textContent === 'frame 11'")
        self.expect_quiet()

        # A phone: nothing is wider than the screen.
        self.browser.open(os.path.join(self.work.name, "tour", "index.html"), width=390, height=800, dark=True, touch=True)
        self.assertLessEqual(run("document.documentElement.scrollWidth"), 390)
        self.assertEqual(run("getComputedStyle(document.body).backgroundColor"), "rgb(20, 22, 26)")
        self.expect_quiet()

    def test_a_check(self):
        self.limen("check", "--views", "10", "--size", "64x36", "--kinds", "random,outside", "--report", "check")
        self.open("check")
        run = self.browser.run
        self.assertEqual(run("byId('verdict').textContent"), "Every pixel is right")
        self.assertEqual(run("document.querySelectorAll('#samples article').length"), 4)
        self.assertTrue(run("[...document.querySelectorAll('#samples article')].every((a) => a.querySelectorAll('img').length === 4)"))
        self.assertTrue(run("[...document.images].every((i) => i.complete && i.naturalWidth > 0)"))
        self.expect_quiet()

    def test_a_check_with_findings(self):
        arguments = ["check", "--views", "4", "--size", "64x36", "--kinds", "random", "--resume", "state.json"]
        self.limen(*arguments)
        path = os.path.join(self.work.name, "state.json")
        with open(path, encoding="utf-8") as file:
            state = json.load(file)
        state["totals"]["kinds"][0]["counts"][6] = 3  # as if the finished part had found three wrong ids
        with open(path, "w", encoding="utf-8") as file:
            json.dump(state, file)
        self.limen(*arguments, "--report", "findings", code=1)
        self.open("findings")
        self.assertIn("3 wrong pixels", self.browser.run("byId('verdict').textContent"))
        self.assertTrue(self.browser.run("byId('verdict').classList.contains('bad')"))
        self.assertEqual(self.browser.run("document.querySelector('td.fault').textContent"), "3")
        self.expect_quiet()


if __name__ == "__main__":
    ReportPages.program, ReportPages.cache = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
