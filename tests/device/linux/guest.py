# SPDX-License-Identifier: MIT
"""The emulated Linux handheld from outside: a shell on its console, a logic analyser on its pins, fingers on its keys.

QEMU's virt machine. Without -icount the guest's clock is the host's, from a moment on: the time stamps of what happens
at the pins are the guest's time. With `counted` an instruction takes 2**counted ns of the guest's time instead: what the
guest measures does not depend on the machine under it, and the stamps mean nothing.
"""
import fcntl
import os
import re
import select
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

from pins import Wires

DEVICE = re.compile(rb":pl061_set_output (\S+) ")


class Guest:
    """A running handheld. Use it in a `with`."""

    def __init__(self, kernel, folder, counted=None, kernel_options="", traced=True):
        self.folder = tempfile.mkdtemp()
        self.wires = Wires(counted is None)
        self.heard = b""
        self.chip = ""  # the GPIO chip as QEMU calls it
        # The trace goes through a pipe and is read as it comes: a picture's is 200 MB.
        pipe = os.path.join(self.folder, "pins")
        os.mkfifo(pipe)
        self.trace = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
        fcntl.fcntl(self.trace, fcntl.F_SETPIPE_SZ, 1 << 20)
        server = socket.socket(socket.AF_UNIX)
        server.bind(os.path.join(self.folder, "qtest"))
        server.listen(1)
        server.settimeout(30)
        self.vm = subprocess.Popen(
            ["qemu-system-arm", "-M", "virt", "-cpu", "cortex-a7", "-m", "256", "-nodefaults", "-display", "none",
             "-no-reboot", "-accel", "tcg", "-serial", "stdio", "-chardev", f"socket,id=qtest,path={self.folder}/qtest",
             "-qtest", "chardev:qtest", "-qtest-log", "none", "-msg", "timestamp=on", "-D", pipe, "-kernel", kernel,
             "-initrd", f"{folder}/initrd.gz", "-dtb", f"{folder}/guest.dtb", "-append",
             f"console=ttyAMA0 quiet loglevel=1 panic=-1 rdinit=/init {kernel_options}"] +
            (["-icount", f"shift={counted},sleep=off"] if counted is not None else []) +
            (["-trace", "pl061_set_output"] if traced else []),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.qtest, _ = server.accept()
        self.qtest.setblocking(False)
        server.close()

    def __enter__(self):
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # the machine goes with it
        self.finish(120)
        return self

    def __exit__(self, *_):
        self.vm.kill()
        self.vm.wait()
        for file in (self.vm.stdin, self.vm.stdout, self.qtest):
            file.close()
        os.close(self.trace)
        shutil.rmtree(self.folder)

    def watch(self):
        """Reads what has happened at the pins."""
        try:
            while listing := os.read(self.trace, 1 << 20):
                self.chip = self.chip or (DEVICE.search(listing) or ["", b""])[1].decode()
                self.wires.feed(listing)
        except BlockingIOError:
            pass

    def listen(self, seconds):
        """Waits for more from the console, at most so long, and watches the pins meanwhile."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            ready, _, _ = select.select([self.vm.stdout, self.trace], [], [], left)
            if self.vm.stdout in ready:
                more = os.read(self.vm.stdout.fileno(), 65536)
                if not more:
                    raise RuntimeError(f"the guest is gone after {self.heard[-500:]!r}")
                self.heard += more
                break
            self.watch()
        self.watch()  # the pins' changes were listed before what the console says after them

    def until(self, mark, seconds):
        """What the console says up to `mark`, without it."""
        end = time.monotonic() + seconds
        while mark not in self.heard:
            if time.monotonic() > end:
                raise RuntimeError(f"the guest fell silent after {self.heard[-500:]!r}")
            self.listen(end - time.monotonic())
        text, self.heard = self.heard.split(mark, 1)
        return text.decode(errors="replace").replace("\r", "")

    def rest(self, seconds):
        """Lets time go by. Who does not watch the pins stops the guest."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            self.listen(left)

    def lines(self):
        """The whole lines that the console has said."""
        *lines, self.heard = self.heard.split(b"\n")
        return [line.decode(errors="replace").replace("\r", "") for line in lines]

    def start(self, line):
        self.vm.stdin.write(line.encode() + b"\n")
        self.vm.stdin.flush()

    def finish(self, seconds=60):
        """The status of the line that was started, and what it printed since."""
        text = self.until(b"\036", seconds)
        return int(self.until(b"\n", 5)), text

    def run(self, line, seconds=60):
        self.start(line)
        return self.finish(seconds)

    def key(self, line, level):
        """Drives a line that the guest reads."""
        self.qtest.sendall(f"set_irq_in {self.chip} unnamed-gpio-in {line} {level}\n".encode())
        answer = b""
        while b"\n" not in answer:
            select.select([self.qtest, self.trace], [], [], 30)
            self.watch()  # or QEMU waits for room in the pipe, and does not answer
            try:
                answer += self.qtest.recv(4096)
            except BlockingIOError:
                pass
        if not answer.startswith(b"OK"):
            raise RuntimeError(f"qtest: {answer!r}")
