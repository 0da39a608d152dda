# SPDX-License-Identifier: MIT
"""What the panels want to be told before the first picture, in order: command, parameters, ms to wait."""

ST7789 = """01 +150; B2 0C0C003333; 3A 05; B7 14; BB 37; C0 2C; C2 01; C3 12; C4 20; D0 A4A1; C6 0F;
    E0 D0040D11132B3F544C180D0B1F23; E1 D0040C11132C3F44512F1F1F2023; 11 +120; 36 00; 21; 2A; 2B; 2C; 29 +100"""
ILI9341 = """01 +150; EF 038002; CF 00C130; ED 64031281; E8 850078; CB 392C003402; F7 20; EA 0000; C0 23; C1 10; C5 3E28; C7 86;
    B1 0013; F2 00; 26 01; E0 0F312B0C0E084EF1370710030E0900; E1 000E1403110731C148080F0C31360F; B6 08C227; 3A 55; 11 +120;
    36 08; 20; 2A; 2B; 2C; 29 +100"""
SSD0323 = """AE; B3 91; A8 3F; A2 40; A1 00; AD 02; 86; B8 0111223243546576; 81 70; B2 51; B1 55; BC 10; BE 1C; BF 0F; A0 52; A4;
    15; 75; PIXELS; AF"""
RESET_MS = {"low": 10, "after": 120}


def complaint(wanted, log):
    """What in a panel's log is not as wanted, or None. Windows and pixels are the picture's affair."""
    steps = [step.split() for step in wanted.replace("\n", " ").split(";")]
    if len(log) < len(steps):
        return f"{len(log)} commands, not {len(steps)}"
    for step, (command, parameters, pause) in zip(steps, log):
        name = "PIXELS" if command is None else f"{command:02X}"
        ms = sum(int(word) for word in step[1:] if word[0] == "+")
        values = [word for word in step[1:] if word[0] != "+"]
        if name != step[0]:
            return f"{name} where {step[0]} is due"
        if values and parameters.hex().upper() != values[0]:
            return f"{name} with {parameters.hex()}, not {values[0]}"
        if pause < 1000 * ms:
            return f"{pause} us behind {name}, not {ms} ms"
    return None
