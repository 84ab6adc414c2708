"""Builds and runs the code of the tutorials from an installed copy. A page's blocks of code are one source, and it prints the
page's block of text."""
import os
import pathlib
import re
import subprocess

PAGES = (("docs/library.md", "cpp", "limen-visibility"), ("docs/tutorials/dat.md", "cpp", "limen-dat"), ("docs/tutorials/c.md", "c", "limen-visibility"),
         ("docs/tutorials/engine.md", "cpp", "limen-engine"), ("docs/tutorials/python.md", "python", None))
COMPILERS = {"cpp": ["g++", "-std=c++20"], "c": ["gcc", "-std=c99"]}


def blocks(text, language):
    return "".join(re.findall(rf"^```{language}\n(.*?)^```", text, re.DOTALL | re.MULTILINE))


def ran(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    return done.stdout if done.returncode == 0 else f"exit {done.returncode} of {' '.join(map(str, command))}\n{done.stdout}{done.stderr}"


def printed(source, language, flags, folder, environment):
    program = folder / source.stem
    built = ran(*COMPILERS[language], "-Wall", "-Wextra", "-Werror", source, "-o", program, *flags)
    return built or ran(program, cwd=folder, env=environment)


def faults(root, folder, flags_of, environment, python_path, cache, has_engine):
    """A line for each page whose code prints another text. flags_of(package): compiler flags. No python_path: no Python. cache:
    the folder of the built-in world."""
    folder.mkdir()
    environment = {**(environment or os.environ), "XDG_CACHE_HOME": str(cache)}
    for page, language, package in PAGES:
        if package == "limen-engine" and not has_engine:
            continue
        text = (root / page).read_text()
        code, expected = blocks(text, language), blocks(text, "text")
        source = folder / f"{pathlib.Path(page).stem}.{language}"
        source.write_text(code)
        if package:
            result = printed(source, language, flags_of(package), folder, environment)
        elif python_path:
            result = ran("/usr/bin/python3", "-B", source, env={**os.environ, "PYTHONPATH": str(python_path)})
        else:
            continue
        if not code or not expected or result != expected:
            yield f"{page}: the code prints\n{result}The page says\n{expected}"
