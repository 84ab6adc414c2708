"""A window on the test's own X server, driven by real keys and mouse and observed frame by frame."""

import json
import os
import queue
import signal
import subprocess
import tempfile
import threading
import time
import unittest
import zlib


def start_server(screen="800x600x24", *options):
    """An Xvfb that chooses a free display itself."""
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", screen, "-nolisten", "tcp", *options],
        pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as pipe:
        number = pipe.readline().strip()
    if not number:
        server.kill()
        raise RuntimeError("Xvfb did not start")
    return server, ":" + number


def png_pixels(path):
    """Width, height and pixel bytes of an 8-bit RGB PNG, with filters undone."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")
    packed, at = b"", 8
    while at < len(data):
        size, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    raw, row, pixels = zlib.decompress(packed), width * 3, bytearray()
    previous = bytearray(row)
    for y in range(height):
        kind, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        for i in range(row):
            left, up, corner = (line[i - 3] if i >= 3 else 0), previous[i], (previous[i - 3] if i >= 3 else 0)
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        pixels += line
        previous = line
    return width, height, bytes(pixels)


class Followed:
    """A window that prints the state of every frame (`--tell`), so that a test waits for states instead of a clock."""

    def __init__(self, test, *arguments, size="480x270", step="0.0333", environment=None, find=True, world=True):
        self.test = test
        self.env = dict(test.env, **(environment or {}))
        self.lines = queue.Queue()
        self.ended = False
        self.events = []  # of the probe
        timing = ["--step", step] if step else []
        self.view = subprocess.Popen([test.program, "view", "--size", size, "--tell", *timing, *arguments], env=self.env, cwd=test.work.name,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.errors = []
        self.threads = [threading.Thread(target=work, daemon=True) for work in (self.read, lambda: self.errors.extend(self.view.stderr))]
        for thread in self.threads:
            thread.start()
        self.saved = []  # files that the program reports when it ends
        self.state = self.next()
        if world:
            self.until(lambda s: "eye" in s, "a world")
        self.window = test.ask("search", "--sync", "--onlyvisible", "--name", "Limen").split()[-1] if find else None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.view.poll() is None:
            self.view.kill()
        self.view.wait()
        for thread in self.threads:
            thread.join(5)
        self.view.stdout.close()
        self.view.stderr.close()

    def read(self):
        for line in self.view.stdout:
            state = json.loads(line)
            if "event" in state:
                self.events.append(state)
            else:
                self.lines.put(state)
        self.lines.put(None)

    def next(self, seconds=120):
        """The next frame's state. Fails after the window has closed."""
        state = self.lines.get(timeout=seconds)
        if state is None:
            self.ended = True
            self.view.wait()
            self.threads[1].join(5)
            self.test.fail("the window left: " + "".join(self.errors))
        self.state = state
        return state

    def latest(self):
        """The latest printed state, at least one frame newer than the last one returned."""
        self.next()
        while not self.lines.empty():
            self.next()
        return self.state

    def until(self, holds, what, frames=2000):
        """Reads frames until the condition holds."""
        for _ in range(frames):
            if holds(self.next()):
                return self.state
        self.test.fail(f"{what} does not come about: {self.state}")

    def do(self, *arguments):
        self.test.ask(*arguments)

    def press(self, key):
        self.do("key", key)

    def page(self, name):
        return self.until(lambda s: s["page"] == name, "the page " + name)

    def choose(self, name):
        """Clicks a control of a page or panel with the mouse. Scrolls down to it."""
        for _ in range(60):
            if name in self.latest()["items"]:
                break
            width, height = self.state["size"]
            self.do("mousemove", str(width // 2), str(height // 2), "click", "5")
        else:
            self.test.fail(f"no control '{name}': {sorted(self.state['items'])}")
        before = None
        while before != self.state["items"].get(name):  # a page that was just opened still moves
            before = self.state["items"].get(name)
            self.latest()
        x, y = self.state["items"][name]
        self.do("mousemove", str(round(x)), str(round(y)))
        self.latest()
        self.do("click", "1")

    def menu(self):
        """Opens the main menu from any page."""
        while self.latest()["page"] != "menu":
            page = self.state["page"]
            self.press("Escape")
            self.until(lambda s: s["page"] != page, "another page")

    def leave(self):
        """Quits in the menu. Returns the exit code and the text on standard error, without the saved files."""
        self.menu()
        self.choose("Quit")
        return self.end()

    def interrupt(self):
        """Ends the program with Ctrl-C. Returns the last state."""
        self.view.send_signal(signal.SIGINT)
        code, errors = self.end()
        self.threads[0].join(5)
        while not self.lines.empty():
            self.state = self.lines.get() or self.state
        self.test.assertEqual(code, 128 + signal.SIGINT, errors)
        return self.state

    def end(self):
        code = self.view.wait(60)
        self.threads[1].join(5)
        self.saved = [line for line in self.errors if line.startswith("limen: saved ")]
        return code, "".join(line for line in self.errors if line not in self.saved)


class WindowTest(unittest.TestCase):
    program = cache = None
    screen = "800x600x24"

    @classmethod
    def setUpClass(cls):
        cls.server, cls.display = start_server(cls.screen)

    @classmethod
    def tearDownClass(cls):
        cls.server.terminate()
        cls.server.wait()

    def setUp(self):
        self.patience = 1
        self.work = tempfile.TemporaryDirectory()
        self.env = dict(os.environ, DISPLAY=self.display, XDG_CACHE_HOME=self.cache, XDG_CONFIG_HOME=os.path.join(self.work.name, "config"))
        self.env.pop("WAYLAND_DISPLAY", None)

    def tearDown(self):
        self.work.cleanup()

    def ask(self, *arguments):
        """The output of xdotool."""
        return subprocess.run(["xdotool", *arguments], env=self.env, check=True, stdout=subprocess.PIPE, text=True).stdout

    def path(self, *names):
        return os.path.join(self.work.name, *names)

    def wait(self, seconds):
        time.sleep(seconds * self.patience)
