// SPDX-License-Identifier: MIT
// drive.mjs MODULES IMAGE.uf2: runs any image on the emulated board that the environment's BOARD names (else a
// PicoSystem) by commands on standard input, one a line, each answered by a line of JSON:
//   run MS         so long of its time      line SECONDS   until the serial line says something: that, or null
//   key NAME 0|1   releases or presses      picture FILE   what is seen, as FILE.raw (RGB565) and FILE.png
//   type TEXT      a serial line's line    faults         what the wires have to complain of
//   feed TEXT      a part of a line, at most 32 bytes at a time
import fs from 'node:fs';
import readline from 'node:readline';
import {flashFromUf2, openBoard} from './board.mjs';
import {png} from './png.mjs';

const [modules, image] = process.argv.slice(2);
let board, heard = 0;

const commands = {
    run: (ms) => board.run(ms / 1000) ?? null,
    line: (seconds) => {
        if (heard === board.lines.length) board.run(+seconds, () => board.lines.length > heard);
        return board.lines[heard]?.text !== undefined ? board.lines[heard++].text : null;
    },
    key: (name, held) => board.press(name, held === '1') ?? null,
    picture: (file) => {
        const shown = board.picture();
        fs.writeFileSync(`${file}.raw`, Buffer.from(shown.pixels.buffer));
        fs.writeFileSync(`${file}.png`, png(shown));
        return [shown.width, shown.height];
    },
    type: (...words) => board.type(words.join(' ') + '\n') ?? null,
    feed: (...words) => board.type(words.join(' ')) ?? null,
    faults: () => [...board.faults, ...board.panel.faults, ...(board.backlight === 1 ? [] : [`backlight at ${board.backlight}`])],
};

try {
    board = openBoard(modules);
    board.boot(flashFromUf2(image));
    for await (const line of readline.createInterface({input: process.stdin})) {
        const [command, ...words] = line.split(' ');
        console.log(JSON.stringify(commands[command](...words)));
    }
} catch (error) {
    console.error(error.message);
    process.exit(3);
}
