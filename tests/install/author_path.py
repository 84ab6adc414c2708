#!/usr/bin/env python3
"""tests/install/author_path.py SOURCE: the way of an engine author from nothing to a flood of a house of one's own.

Follows the section "From nothing to a flood of your own house" of docs/library.md in an empty folder, with the page's own commands and
code, and compares the output with the page. Then it adds up the minutes: words to read (the section of README.md that leads there, and
that of the page), characters to type, and the seconds that the commands take, with a minute for apt-get, whose packages this machine has already. Exit 1: a command fails, the output differs, the way takes
more than 15 minutes, or docs/api-stability.md has other figures.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(sys.argv[1])
WORDS_A_MINUTE, CHARACTERS_A_MINUTE, APT_MINUTES, MOST_MINUTES = 200, 150, 1, 15


def section(page, heading):
    text = (SOURCE / page).read_text()
    found = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", text, re.DOTALL | re.MULTILINE)
    return found.group(1) if found else sys.exit(f"{page} has no section {heading}")


def blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.DOTALL | re.MULTILINE)


def follow(commands, folder, environment):
    """Runs the commands in the empty folder, and gives their output and seconds. Packages are installed already."""
    start = time.monotonic()
    done = subprocess.run(["bash", "-e", "-c", commands], cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"exit {done.returncode} of\n{commands}{done.stdout}{done.stderr}")
    return done.stdout, time.monotonic() - start


def main(folder):
    (folder / "limen").symlink_to(SOURCE)
    page = section("docs/library.md", "From nothing to a flood of your own house")
    start = (SOURCE / "docs/library.md").read_text().split("\n## ")[0]
    read = section("README.md", "In your own engine") + start + page
    install, build = blocks(page, "sh")
    code = "".join(blocks(page, "cpp"))
    (folder / "house.cpp").write_text(code)
    # As on the author's machine: no cache of compiled sources.
    environment = {**os.environ, "HOME": str(folder), "CCACHE_DISABLE": "1"}
    environment.pop("PKG_CONFIG_PATH", None)
    _, seconds = follow("".join(line for line in install.splitlines(keepends=True) if not line.startswith("apt-get ")), folder, environment)
    printed, more = follow(build, folder, environment)
    if [printed] != blocks(page, "text"):
        sys.exit(f"the code prints\n{printed}The page says\n{''.join(blocks(page, 'text'))}")
    words, characters = len(read.split()), len(install) + len(build) + len(code)
    minutes = words / WORDS_A_MINUTE + characters / CHARACTERS_A_MINUTE + APT_MINUTES + (seconds + more) / 60
    print(f"{words:,} words, {characters:,} characters, {seconds + more:.0f} s of commands: {minutes:.1f} minutes")
    if minutes > MOST_MINUTES:
        sys.exit(f"more than {MOST_MINUTES} minutes")
    figures = f"{words:,} words and {characters:,} characters"
    if figures not in " ".join((SOURCE / "docs/api-stability.md").read_text().split()):
        sys.exit(f"docs/api-stability.md does not say: {figures}")


# Outside of the repository: a link to it from within would be a loop for programs that walk through its folders.
with tempfile.TemporaryDirectory(prefix="limen-author-") as empty:
    main(pathlib.Path(empty))
