# SPDX-License-Identifier: MIT
"""What has to hold of pictures over USB. Each case is a generator of verdicts: a name, and what is wrong or None."""
import re

from usb import BARE, DEMO, GADGET, PLAIN, STEP, Pictures, trace

RGB = "--format rgb565 --tables 1"
RATE = 60  # pictures a second
PULLS = 50
BACK_S = 2


def numbers(pictures):
    """None if all that was sent was shown, the first a key frame."""
    if not pictures or not pictures[0].key:
        return "the first is no key frame"
    for a, b in zip(pictures, pictures[1:]):
        if b.number != a.number + 1:
            return f"number {b.number} after {a.number}"
    return None


def all_right(usb, glint, name, device, kind, count=300):
    """So many pictures in a row, each the host's of its moment."""
    complaint = usb.play(device)
    if complaint:
        yield name, complaint
        return
    status, pictures, text, said = usb.view(f"--frames {count}")
    if status or len(pictures) != count:
        complaint = f"status {status}, {len(pictures)} pictures: {said or text[-500:]}"
    elif not text.endswith(" 0 lost\n"):
        complaint = text.splitlines()[-1]
    size = sum(p.bytes for p in pictures) // max(len(pictures), 1)
    complaint = complaint or numbers(pictures) or Pictures(glint, kind).complaint(pictures)
    skipped = pictures[-1].skipped if pictures else 0
    yield f"{name}: {count} pictures are the host's, {size} bytes each, {skipped} left out", complaint
    status = usb.stop()
    yield f"{name}: the device ends", f"status {status}" if status else usb.left()


def pictures(usb, glint):
    yield from all_right(usb, glint, "240x240", f"{PLAIN} {DEMO}", f"{RGB} --size 240x240")


def sizes(usb, glint):
    yield from all_right(usb, glint, "320x240", f"{BARE} --panel none --size 320x240 {DEMO}", f"{RGB} --size 320x240", 60)
    yield from all_right(usb, glint, "37x23", f"{BARE} --panel none --size 37x23 {DEMO}", f"{RGB} --size 37x23", 60)
    yield from all_right(usb, glint, "dithered", f"{PLAIN} --dither {DEMO}", f"{RGB} --dither --size 240x240", 60)


def cable(usb, glint):
    """The cable is pulled at moments that are spread over a picture's period, from the arrival of a picture's end on."""
    complaint = usb.play(f"{PLAIN} {DEMO}")
    status, text = (1, complaint) if complaint else usb.guest.run(
        f"glint-view usb: --headless --trace 2>/tmp/said | cable {usb.udc()} {PULLS} {1000000 // RATE}", 300)
    shown, outs, ins = trace(text), [], []
    for line in text.splitlines():
        if found := re.match(r"(\d+) (out|in), ", line):
            (outs if found[2] == "out" else ins).append(int(found[1]))
    back = [min([p.stamp for p in shown if p.stamp > moment and p.key] or [1e12]) - moment for moment in ins]
    longest = max(back, default=1e12) / 1e6
    if status or len(back) != PULLS:
        complaint = f"status {status}, pulled {len(back)} times: {text[-300:]} {usb.do('cat /tmp/said')} {usb.do('cat /tmp/device')}"
    yield (f"the cable is pulled {PULLS} times, at moments spread over a picture: the next picture comes {longest:.3f} s after it is in "
           f"again at the latest", complaint or (None if longest <= BACK_S else f"{[round(b / 1e6, 3) for b in back]}"))
    yield f"none of {len(shown)} pictures is a wrong one", Pictures(glint, f"{RGB} --size 240x240").complaint(shown)
    keys = sum(p.key for p in shown)
    lost = shown[-1].number - shown[0].number + 1 - len(shown) if shown else 0
    yield (f"{lost} of those that were sent were not shown, {keys} key frames",
           None if shown and lost <= 2 * PULLS and keys >= PULLS else "not plausible")
    drawn = (shown[-1].moment - shown[0].moment) / STEP if shown else 0
    took = (shown[-1].stamp - shown[0].stamp) / 1e6 if shown else 1
    yield f"the device drew {drawn / took:.1f} pictures a second meanwhile", None if drawn / took > .8 * RATE else "too few"
    status = usb.stop()
    yield "and ends as always", f"status {status}" if status else usb.left()


def stopped(usb, glint):
    """A host that is there and does not read."""
    complaint = usb.play(f"{PLAIN} {DEMO}")
    usb.watch()
    complaint = complaint or (None if usb.until_pictures(30) else "no pictures")
    usb.do(f"kill -STOP {usb.viewer}")
    before = len(usb.seen())
    usb.do(f"sleep 5; kill -CONT {usb.viewer}; sleep 1")
    shown = usb.leave()
    jumps = [b.moment - a.moment for a, b in zip(shown, shown[1:])]
    jump = max(jumps, default=0)
    at = jumps.index(jump) + 1 if jumps else 0
    old, drawn = at - before, jump // STEP
    skipped = shown[-1].skipped - shown[0].skipped if shown else 0
    missing = sum(j // STEP - 1 for j in jumps)
    yield (f"a host does not read for 5 s: {old} pictures from before it stopped, then one that is {drawn} later",
           complaint or (None if 4.5 * RATE < drawn + old < 5.5 * RATE and 0 <= old < 60 else f"jumps {jumps}"))
    lost = shown[-1].number - shown[0].number + 1 - len(shown) if shown else 0
    yield (f"{skipped} are counted as left out and {lost} had waited for it too long, {missing} are missing",
           None if skipped + lost == missing and lost <= 3 else "not the same")
    yield "none of those after it is a wrong one", Pictures(glint, f"{RGB} --size 240x240").complaint(shown)
    yield f"{len(shown) - at} came in the second after it", None if len(shown) - at > .8 * RATE else "too few"
    seen = []
    for _ in range(3):
        usb.do("sleep 3")
        seen += [p.moment for p in usb.view("--frames 1")[1]]
    passed = [b - a for a, b in zip(seen, seen[1:])]
    yield f"who looks every 3 s sees a picture of then: moments {seen}", \
        None if len(passed) == 2 and min(passed) > .9 * 3 * RATE * STEP and seen[0] - shown[-1].moment > .9 * 3 * RATE * STEP else "old ones"
    status = usb.stop()
    yield "the device ends as always", f"status {status}" if status else usb.left()


def two(usb, glint):
    complaint = usb.play(f"{PLAIN} {DEMO}")
    usb.watch()
    complaint = complaint or (None if usb.until_pictures(10) else "the first has no pictures")
    count = len(usb.seen())
    status, said = usb.guest.run("glint-view usb: --headless --wait 2 --frames 1")
    good = status == 3 and "in use" in said and said.count("\n") == 1
    yield f"a second viewer is refused: {said.strip()}", complaint or (None if good else f"status {status}: {said}")
    usb.until_pictures(count + 60)
    shown = usb.leave()
    yield f"the first does not notice: {len(shown)} pictures", numbers(shown) or \
        ("it had to begin anew" if any(p.key for p in shown[count:]) else None) or Pictures(glint, f"{RGB} --size 240x240").complaint(shown)
    status, shown, _, said = usb.view("--frames 5")
    yield "when it has left, another may come, and begins with a key frame", f"status {status}: {said}" if status else numbers(shown)
    usb.stop()


def requests(usb, glint):
    """What the viewer asks for is what is then streamed."""
    complaint = usb.play(f"{PLAIN} --figures=off --scene demo --method gouraud --step {STEP}")
    for scene, method, budget in (("torus800", "phong", 4), ("demo", "x", 9), ("sphere690", "subdivide-centre", 40)):
        status, shown, text, said = usb.view(f"--scene {scene} --method {method} --budget {budget} --pause --frames 1")
        options = [method] if "-" not in method else [method.split("-")[0], "--subdivide", method.split("-")[1]]
        host = Pictures(glint, f"{RGB} --size 240x240", scene, options[0], options[1:] + ["--tolerance", str(budget)])
        yield (f"asked for {scene} by {method}, budget {budget}, standing: it comes",
               complaint or (f"status {status}: {said}{text}" if status else None) or host.complaint(shown) or
               (None if shown else "no picture"))
    status, shown, _, said = usb.view("--run --frames 10")
    moves = len({p.moment for p in shown}) == 10
    yield "and goes on when told to", f"status {status}: {said}" if status else None if moves else f"{[p.moment for p in shown]}"
    usb.view("--pause --scene demo --method x --frames 1")
    status, said = usb.guest.run("bogus ask 82 8 300; bogus ask 82 0 100")
    told = [line for line in usb.do("cat /tmp/device").splitlines() if "turn " in line][-1:]
    turn = re.search(r"turn (\S+),(\S+),", told[0]) if told else None
    more = ["--turn", f"{turn[1]},{turn[2]}"] if turn else []
    status, shown, _, said = usb.view("--frames 1")
    moment = shown[-1].moment if shown else 0
    host = Pictures(glint, f"{RGB} --size 240x240", "demo", "x", more).hashes("--time", str(moment))[0]
    good = turn and float(turn[1]) > 0 and shown and shown[-1].crc == host
    yield f"a button that is held turns the object: {turn and turn[0]}", None if good else f"{said}{told} {[p.crc for p in shown]}, not {host}"
    usb.stop()


def bogus(usb, glint):
    complaint = usb.play(f"{PLAIN} {DEMO}")
    said = usb.do("bogus describe")
    packet = 64 if usb.speed == "full speed" else 512
    wanted = ("device 1209:0001", "manufacturer Glint\n", "product Glint ", "class ff subclass 47 protocol 01",
              f"in 81 bulk packet {packet}\n", "string ee 18 bytes MSFT100\n", "WINUSB", "DeviceInterfaceGUID")
    missing = [word for word in wanted if word not in said]
    yield "it describes itself, to Windows too", complaint or (f"no {missing} in {said}" if missing else None)
    usb.watch()
    usb.until_pictures(10)
    status, said = usb.guest.run("bogus requests 1 600", 200)
    yield f"control requests of no sense: {', '.join(said.splitlines())}", f"status {status}" if status else None
    count = len(usb.seen())
    usb.until_pictures(count + 60)
    shown = usb.leave()
    yield f"the stream goes on meanwhile and behind: {len(shown)} pictures", \
        numbers(shown) or (None if len(shown) >= count + 60 else "no more") or Pictures(glint, f"{RGB} --size 240x240").complaint(shown)
    status, said = usb.guest.run("bogus seize 2 600", 200)
    yield f"the same from who has the interface, and bytes of no sense: {', '.join(said.splitlines())}", f"status {status}" if status else None
    status, shown, _, said = usb.view("--frames 30")
    yield "a viewer that finds both endpoints halted goes on", f"status {status}: {said} {usb.do('cat /tmp/device')}" if status else \
        numbers(shown) or Pictures(glint, f"{RGB} --size 240x240").complaint(shown)
    status = usb.stop()
    yield "and the device ends as always", f"status {status}: {usb.do('cat /tmp/device')}" if status else usb.left()


def refused(usb, name, line, words, status=3):
    got, said = usb.guest.run(line)
    good = got == status and said.count("\n") == 1 and re.search(words, said)
    return f"{name}: {said.strip()}", (None if good else f"status {got}") or usb.left()


def starts(usb, glint):
    line = f"glint-device {PLAIN} {DEMO} --frames 3"
    yield refused(usb, "not by anybody", f"su -s /bin/sh nobody -c '{line}'", "ermission|root")
    usb.do("rmmod dummy_hcd")
    yield refused(usb, "no USB device controller", line, "/sys/class/udc|controller|UDC")
    usb.do(f"insmod /modules/dummy_hcd.ko is_high_speed={int(usb.speed == 'high speed')}")
    for round in range(5):
        complaint = usb.play(f"{PLAIN} {DEMO}")
        usb.watch()
        usb.until_pictures(5)
        usb.do(f"usleep {round * 3400}")
        status = usb.stop()
        yield f"SIGTERM in the middle of pictures, {round + 1}", complaint or (f"status {status}" if status else None) or usb.left()
        usb.leave()
    complaint = usb.play(f"{PLAIN} {DEMO}")
    status, said = usb.guest.run(line)
    yield f"a second one finds the controller busy: {said.strip()}", \
        complaint or (None if status == 3 and said.count("\n") == 1 else f"status {status}")
    usb.watch()
    usb.until_pictures(5)
    yield "SIGKILL ends the first, and leaves its gadget", None if usb.stop("KILL") == 137 and usb.left() else "not so"
    count = len(usb.seen())
    complaint = usb.play(f"{PLAIN} {DEMO}")
    found = usb.until_pictures(count + 60)
    shown = usb.leave()
    yield f"after that it starts again, and the viewer has its pictures: {len(shown)}", \
        complaint or (None if found else "no more") or Pictures(glint, f"{RGB} --size 240x240").complaint(shown)
    status = usb.stop()
    yield "nothing is left of both", f"status {status}" if status else usb.left()


def faster(usb, glint):
    """A controller that can do more than high speed."""
    usb.do("rmmod dummy_hcd; insmod /modules/dummy_hcd.ko is_super_speed=1")
    yield from all_right(usb, glint, "super speed", f"{PLAIN} {DEMO}", f"{RGB} --size 240x240", 60)
