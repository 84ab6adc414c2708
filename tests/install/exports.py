#!/usr/bin/env python3
"""tests/install/exports.py LIBRARY FOLDER: the names that a shared library exports, compared with the public headers below a folder.

Each name is one that a header declares. A name of a private member is among them, because headers declare those, too. Prints the number
of names. Exit 1: a name that no header has, or so few names that the comparison means nothing.
"""
import pathlib
import re
import subprocess
import sys


def faults(library, headers):
    """The faults of a library, as texts; `headers`: the paths of all public headers."""
    words = set(re.findall(r"\w+", "\n".join(header.read_text() for header in headers)))
    names = names_of(library)
    if len(names) < 20:
        yield f"{library.name} exports too few names for this check to mean anything: {names}"
    for name in names:
        plain = re.sub(r"<.*|\(.*|\[abi:\w+\]", "", name.split("limen::", 1)[-1] if "limen::" in name else name)
        parts = [part for part in re.split(r"::|\s", plain) if part and not part.startswith(("~", "operator"))]
        if "limen" not in name or not parts or not set(parts) <= words:
            yield f"{library.name} exports {name}, which no public header declares"


def names_of(library):
    listed = subprocess.run(["nm", "-D", "--defined-only", "-C", str(library)], capture_output=True, text=True, check=True).stdout
    return [line.split(None, 2)[2] for line in listed.splitlines()]


def main():
    library, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    found = list(faults(library, sorted(folder.rglob("*.h"))))
    if found:
        sys.exit("\n".join(found))
    print(f"{library.name}: {len(names_of(library))} names, all of public headers")


if __name__ == "__main__":
    main()
