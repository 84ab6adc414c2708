"""A program that drags files over another window and drops them there (the XDND protocol, version 5)."""

import ctypes
import time

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
ULONG, LONG, INT, POINTER = ctypes.c_ulong, ctypes.c_long, ctypes.c_int, ctypes.c_void_p


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", INT), ("serial", ULONG), ("send_event", INT), ("display", POINTER), ("window", ULONG),
                ("message_type", ULONG), ("format", INT), ("data", LONG * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", INT), ("serial", ULONG), ("send_event", INT), ("display", POINTER), ("owner", ULONG), ("requestor", ULONG),
                ("selection", ULONG), ("target", ULONG), ("property", ULONG), ("time", ULONG)]


class SelectionNotify(ctypes.Structure):
    _fields_ = [("type", INT), ("serial", ULONG), ("send_event", INT), ("display", POINTER), ("requestor", ULONG), ("selection", ULONG),
                ("target", ULONG), ("property", ULONG), ("time", ULONG)]


class Event(ctypes.Union):
    _fields_ = [("type", INT), ("client", ClientMessage), ("request", SelectionRequest), ("notify", SelectionNotify), ("pad", LONG * 24)]


class DragSource:
    """Owns the selection of a drag. `drop` performs all of it."""

    def __init__(self, display):
        self.x = ctypes.CDLL("libX11.so.6")
        self.x.XOpenDisplay.restype = POINTER
        for name in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
            getattr(self.x, name).restype = ULONG
        self.display = POINTER(self.x.XOpenDisplay(display.encode()))
        root = ULONG(self.x.XDefaultRootWindow(self.display))
        self.window = self.x.XCreateSimpleWindow(self.display, root, 0, 0, 1, 1, 0, ULONG(0), ULONG(0))

    def close(self):
        self.x.XCloseDisplay(self.display)

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def send(self, target, kind, *data):
        event = Event(client=ClientMessage(type=CLIENT_MESSAGE, display=self.display, window=target, message_type=self.atom(kind), format=32,
                                           data=(LONG * 5)(self.window, *data)))
        self.x.XSendEvent(self.display, ULONG(target), 0, LONG(0), ctypes.byref(event))
        self.x.XFlush(self.display)

    def serve(self, request, uris):
        data = uris.encode()
        self.x.XChangeProperty(self.display, ULONG(request.requestor), ULONG(request.property), ULONG(request.target), 8, 0, data, len(data))
        event = Event(notify=SelectionNotify(type=SELECTION_NOTIFY, display=self.display, requestor=request.requestor,
                                             selection=request.selection, target=request.target, property=request.property, time=request.time))
        self.x.XSendEvent(self.display, ULONG(request.requestor), 0, LONG(0), ctypes.byref(event))
        self.x.XFlush(self.display)

    def until(self, answer, uris, seconds=60):
        """Serves the target's requests until its message arrives. Returns the message's data."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if not self.x.XPending(self.display):
                time.sleep(0.01)
                continue
            event = Event()
            self.x.XNextEvent(self.display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                self.serve(event.request, uris)
            elif event.type == CLIENT_MESSAGE and event.client.message_type == self.atom(answer):
                return list(event.client.data)
        raise TimeoutError(answer)

    def drop(self, target, x, y, uris):
        """Drops the text `uris` (lines of file:// addresses) on the window at a place of the screen."""
        target = int(target)
        selection, kind = self.atom("XdndSelection"), self.atom("text/uri-list")
        self.x.XSetSelectionOwner(self.display, ULONG(selection), ULONG(self.window), ULONG(0))
        self.send(target, "XdndEnter", 5 << 24, kind, 0, 0)
        self.send(target, "XdndPosition", 0, x << 16 | y, 0, self.atom("XdndActionCopy"))
        accepts = self.until("XdndStatus", uris)[1] & 1
        if accepts:
            self.send(target, "XdndDrop", 0, 0, 0, 0)
            accepts = self.until("XdndFinished", uris)[1]  # GLFW gives the number of bytes, not 1
        return bool(accepts)
