"""Finds the commands in the project's pages: README.md and docs/manual/*.md."""

import re
from dataclasses import dataclass

PLACEHOLDER = re.compile(r"(?<![\w.])[A-Z][A-Z_]{2,}(?![\w.])")
NOT_RUN = re.compile(r"<!-- not run: (.+?) -->")
EXIT = re.compile(r"\s+# exit (\d+)\s*$")


@dataclass
class Example:
    page: str
    line: int
    command: str
    exit: int = 0
    not_run: str = ""  # the reason

    def __str__(self):
        return f"{self.page}:{self.line}: {self.command}"


def blocks(text):
    """Yields (line number, reason not to run, lines) of each fenced `sh` block and each indented block."""
    reason, fence, fence_reason, block, start = "", None, "", [], 0
    in_list = False
    for number, line in enumerate(text.split("\n") + [""], 1):
        stripped = line.strip()
        if fence is not None:
            if stripped.startswith("```"):
                if fence == "sh":
                    yield start, fence_reason, block
                fence, block = None, []
            else:
                block.append(line)
            continue
        if line.startswith("    ") and not in_list:
            if not block:
                start = number
            block.append(line[4:])
            continue
        if block:
            yield start, reason, block
            block, reason = [], ""
        if stripped.startswith("```"):
            fence, fence_reason, reason, start = stripped[3:].strip(), reason, "", number + 1
        elif NOT_RUN.search(line):
            reason = NOT_RUN.search(line).group(1)
        elif stripped:
            reason = ""
            in_list = bool(re.match(r"\s*([-*]|\d+\.)\s", line)) or (in_list and line.startswith(" "))


def examples(page, text):
    """The commands of one page. Other lines of a block, such as comments, are no examples."""
    found = []
    for start, reason, lines in blocks(text):
        joined, begin = "", start
        for offset, line in enumerate(lines):
            begin = begin if joined else start + offset
            joined += line.strip()
            if joined.endswith("\\"):
                joined = joined[:-1].rstrip() + " "
                continue
            command, joined = joined, ""
            if not re.match(r"(limen|\./run)(\s|$)", command):
                continue
            expected = EXIT.search(command)
            command = re.sub(r"\s+#.*$|\s{3,}\S.*$", "", command).strip()  # a comment, or an explanation in a column
            why = reason
            bare = re.sub(r"^\./run", "limen", command)
            if not why and PLACEHOLDER.search(bare):
                why = "has a placeholder"
            elif not why and re.match(r"limen( view(?!.*--frames)|$)", bare):
                why = "opens a window until the user quits"
            found.append(Example(page, begin, bare, int(expected.group(1)) if expected else 0, why))
    return found
