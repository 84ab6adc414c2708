"""The messages of docs/manual/troubleshooting.md exist in the sources. Argument: the source tree."""

import pathlib
import re
import sys
import unittest

SOURCE = pathlib.Path(sys.argv[1])
PAGE = SOURCE / "docs" / "manual" / "troubleshooting.md"
LITERAL = re.compile(r'"((?:\\.|[^"\\\n])*)"')


def sources():
    """The text of all string literals, with adjacent literals joined and replacement fields as {}."""
    texts = []
    for folder in ("src", "worlds", "bench"):
        for file in sorted((SOURCE / folder).rglob("*.cpp")):
            code = re.sub(r'"\s*\n\s*"', "", file.read_text())
            for text in LITERAL.findall(code):
                texts.append(re.sub(r"\{[^{}]*\}", "{}", text.replace('\\"', '"')))
    return "\n".join(texts)


def quoted():
    """The headings of the page: one message each. Capital words stand for replacement fields."""
    return re.findall(r"^### `(.+)`$", PAGE.read_text(), re.MULTILINE)


class MessagesTest(unittest.TestCase):
    def test_the_page_has_messages(self):
        self.assertGreaterEqual(len(quoted()), 25)
        self.assertEqual(len(quoted()), len(set(quoted())))

    def test_every_message_is_in_the_sources(self):
        texts = sources()
        for message in quoted():
            # "..." stands for a part that varies; every other part must be in one literal.
            for part in message.split("..."):
                part = part.strip()
                if len(part) > 3:
                    self.assertIn(part, texts, f"no source has the message: {message}")

    def test_an_invented_message_is_not_found(self):
        self.assertNotIn("this message was never written", sources())

    def test_every_message_has_cause_and_remedy(self):
        for section in PAGE.read_text().split("\n### ")[1:]:
            heading = section.split("\n")[0]
            self.assertIn("**Cause.**", section, heading)
            self.assertIn("**Remedy.**", section, heading)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
