#!/usr/bin/env python3
"""Screenshot.py PAGE PICTURE.png WxH: saves the top of a report page as a browser shows it."""

import sys

from Browser import Browser

page, picture, size = sys.argv[1:]
width, height = map(int, size.split("x"))
with Browser() as browser:
    browser.open(page, width, height)
    # A frame of the middle of a tour.
    browser.run("(() => { const s = document.getElementById('frame'); if (s) { s.value = s.max / 2; s.dispatchEvent(new Event('input')); } })()")
    browser.screenshot(picture, whole=False)
    if browser.errors:
        sys.exit("Screenshot: " + "; ".join(browser.errors))
