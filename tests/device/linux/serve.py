# SPDX-License-Identifier: MIT
"""serve.py KERNEL GUEST BOARD PORT [OPTION...]: the emulated handheld in a browser at http://localhost:PORT, with its keys;
until it is interrupted. The page, and what it asks for, are those of ../rp2040/serve.mjs."""
import http.server
import json
import os
import struct
import sys
import threading
import time
import urllib.parse

from play import KEYS, Player

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../rp2040/handheld.html")


class Handheld:
    """The player between the thread that runs it and those that answer."""

    def __init__(self, player):
        self.player, self.change = player, threading.Condition()
        self.keys, self.lines, self.seen = [], [], -1
        self.begin = time.monotonic()

    def run(self):
        while True:
            with self.change:
                while self.keys:
                    self.player.guest.key(*self.keys.pop(0))
                self.player.guest.listen(.02)
                said = self.player.lines()
                self.lines += said
                self.change.notify_all()
            print("".join(line + "\n" for line in said), end="", flush=True)
            time.sleep(.001)  # lets those in who wait

    def press(self, name, held):
        with self.change:
            self.keys.append((KEYS[name], held))

    def picture(self):
        """Waits for a change: the pixels as RGB565, and what else there is."""
        with self.change:
            self.change.wait_for(lambda: self.lines or self.seen != self.player.guest.wires.bytes, 10)
            self.seen = self.player.guest.wires.bytes
            pixels = [0] * len(self.player.pixels()) if self.player.panel.dark() else self.player.pixels()
            lit = self.player.panel.lit
            state = {"seconds": time.monotonic() - self.begin, "speed": 1, "backlight": lit[-1][0] if lit else 0,
                     "lines": self.lines, "faults": self.player.faults()}
            self.lines = []
        if self.player.greys:
            pixels = [(17 * p >> 3) << 11 | (17 * p >> 2) << 5 | 17 * p >> 3 for p in pixels]
        return struct.pack(f"<{len(pixels)}H", *pixels), state


class Request(http.server.BaseHTTPRequestHandler):
    handheld = None

    def answer(self, status, kind="text/plain", body=b"", state=None):
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Cache-Control", "no-store")
        if state:
            self.send_header("X-State", urllib.parse.quote(json.dumps(state)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        player = self.handheld.player
        if self.path == "/":
            with open(PAGE, "rb") as page:
                self.answer(200, "text/html; charset=utf-8", page.read())
        elif self.path == "/board":
            width, height = player.glass
            board = {"name": "an emulated Linux handheld", "buttons": KEYS,
                     "glass": {"width": width, "height": height, "turned": player.turn}}
            self.answer(200, "application/json", json.dumps(board).encode())
        elif self.path == "/picture":
            pixels, state = self.handheld.picture()
            self.answer(200, "application/octet-stream", pixels, state)
        else:
            self.answer(404, body=b"nothing here\n")

    def do_POST(self):
        query = dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(self.path).query))
        known = query.get("name") in KEYS
        if known:
            self.handheld.press(query["name"], int(query.get("held") == "1"))
        self.answer(204 if known else 404)

    def log_message(self, *_):
        pass


def main():
    if len(sys.argv) < 5 or not sys.argv[4].isdigit():
        sys.exit("usage: serve.py KERNEL GUEST BOARD PORT [OPTION...]")
    kernel, folder, board, port = sys.argv[1:5]
    try:
        server = http.server.ThreadingHTTPServer(("127.0.0.1", int(port)), Request)
    except OSError as error:
        print(f"port {port}: {error.strerror}; give another, PORT=", file=sys.stderr)
        sys.exit(3)
    server.daemon_threads = True
    with Player(kernel, folder, board, sys.argv[5:]) as player:
        Request.handheld = Handheld(player)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        print(f"http://localhost:{port} (Ctrl-C ends it)", flush=True)
        try:
            Request.handheld.run()
        except KeyboardInterrupt:
            pass


if __name__ == "__main__":
    main()
