# SPDX-License-Identifier: MIT
"""An X screen of its own, its pixels and its keys: Xvfb, which keeps its pixels in a file, and xdotool."""
import ctypes
import mmap
import os
import struct
import subprocess
import time

PATIENCE = 10  # seconds: until something that must happen has failed


def wait_for(what, seconds=PATIENCE):
    """What `what` returns when it is true, or what it does in the end."""
    end = time.monotonic() + seconds
    while not (result := what()) and time.monotonic() < end:
        time.sleep(.02)
    return result


class ClientMessage(ctypes.Structure):
    """XClientMessageEvent, and the room of any XEvent."""
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("room", ctypes.c_char * 96)]


class Screen:
    def __init__(self, folder, size):
        self.folder = folder
        back, front = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(front), "-screen", "0", f"{size}x{size}x24", "-fbdir", folder, "-nolisten", "tcp", "-noreset"],
            pass_fds=[front], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(front)
        with os.fdopen(back) as told:
            self.name = ":" + told.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.name, SDL_RENDER_DRIVER="software", SDL_FRAMEBUFFER_ACCELERATION="0")
        self.environment.pop("SDL_VIDEODRIVER", None)
        with open(f"{folder}/leaks", "w", encoding="ascii") as file:  # what SDL's own libraries keep
            file.write("leak:libdbus-1\n")
        self.environment["LSAN_OPTIONS"] = f"suppressions={folder}/leaks:print_suppressions=0"

    def close(self):
        self.server.terminate()
        self.server.wait()

    def tool(self, *words):
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True).stdout

    def pixels(self, x, y, width, height):
        """RGB rows of a part of the screen, from the XWD file; empty if it is not all on it."""
        with open(f"{self.folder}/Xvfb_screen0", "rb") as file:
            data = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
        head = struct.unpack_from(">20I", data)
        begin, pitch = head[0] + 12 * head[19], head[12]
        if x < 0 or y < 0 or x + width > head[4] or y + height > head[5]:
            return b""
        rows = []
        for line in range(y, y + height):
            row = data[begin + line * pitch + 4 * x:][:4 * width]
            out = bytearray(3 * width)
            out[0::3], out[1::3], out[2::3] = row[2::4], row[1::4], row[0::4]
            rows.append(bytes(out))
        return b"".join(rows)


class Window:
    """That of a process, once it is there, with the keyboard."""

    def __init__(self, screen, process):
        self.screen = screen
        found = wait_for(lambda: screen.tool("search", "--onlyvisible", "--all", "--pid", process, "--name", "Glint$").split())
        self.window = found[0] if found else "0"
        wait_for(lambda: screen.tool("windowfocus", self.window, "getwindowfocus", "-f").strip() == self.window)

    def title(self):
        return self.screen.tool("getwindowname", self.window).strip()

    def place(self):
        """x, y, width, height"""
        told = dict(line.split("=") for line in self.screen.tool("getwindowgeometry", "--shell", self.window).split())
        return tuple(int(told.get(name, 0)) for name in ("X", "Y", "WIDTH", "HEIGHT"))

    def pixels(self):
        return self.screen.pixels(*self.place())

    def keys(self, *names):
        self.screen.tool("key", "--delay", 5, *names)

    def close(self):
        """As by the cross in its frame."""
        x = ctypes.CDLL("libX11.so.6")
        x.XOpenDisplay.restype = ctypes.c_void_p
        x.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
        x.XInternAtom.restype = ctypes.c_ulong
        x.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
        x.XCloseDisplay.argtypes = [ctypes.c_void_p]
        display = x.XOpenDisplay(self.screen.name.encode())
        event = ClientMessage(type=33, window=int(self.window), format=32,
                              message_type=x.XInternAtom(display, b"WM_PROTOCOLS", 0))
        event.data[0] = x.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
        x.XSendEvent(display, int(self.window), 0, 0, ctypes.byref(event))
        x.XCloseDisplay(display)
