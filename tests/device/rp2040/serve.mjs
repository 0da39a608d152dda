// SPDX-License-Identifier: MIT
// serve.mjs MODULES IMAGE.uf2 PORT: runs any image on the emulated board that the environment's BOARD names (else a
// PicoSystem) and shows it in a browser at http://localhost:PORT, buttons and serial line too; until it is interrupted.
// It runs no faster than the board, and only while a page looks on.
//
//   GET /          the page             GET /board     the board's wires.json
//   GET /picture   answers when the panel has changed: RGB565 rows; header X-State: JSON of what else there is
//   POST /button?name=A&held=1          presses a button; held=0 releases it
import fs from 'node:fs';
import http from 'node:http';
import {flashFromUf2, openBoard} from './board.mjs';

const SLICE_S = 0.004, LINGER_MS = 3000, BEHIND_MS = 100;
const TAP_NANOS = 120e6; // of the board's time at the least between two changes of a button: it looks once a picture
const [modules, image, port] = process.argv.slice(2);

function fail(message, code = 3) {
    console.error(message);
    process.exit(code);
}
if (port === undefined) fail('usage: serve.mjs MODULES IMAGE.uf2 PORT', 2);
if (!/^\d+$/.test(port) || port > 65535) fail(`PORT=${port}: no port, 0 to 65535`, 2);

let board, lines = [], lookedAt = -Infinity, code;
try {
    board = openBoard(modules);
    board.boot(flashFromUf2(image));
} catch (error) {
    fail(error.message);
}
board.onLine = (text) => {
    console.log(text);
    lines.push(text);
};

// Changes of buttons that wait for their time: a finger is faster than an emulated board.
const queue = [], changed = {};
function pressDue() {
    const now = board.clock.nanos;
    for (let i = 0; i < queue.length; i++) {
        const {name, held} = queue[i];
        if (now - (changed[name] ?? -TAP_NANOS) < TAP_NANOS || queue.slice(0, i).some((before) => before.name === name)) continue;
        board.press(name, held);
        changed[name] = now;
        queue.splice(i--, 1);
    }
}

const waiting = []; // requests for the next picture
let sentBytes = -1, wallBegin = performance.now(), boardBegin = 0, speed = 0;
function answer() {
    const bytes = board.panel.bytes.command + board.panel.bytes.data;
    if (!waiting.length || bytes === sentBytes && !lines.length) return;
    const shown = board.picture(), state = {seconds: board.clock.nanos / 1e9, speed,
        backlight: board.backlight, lines, faults: [...board.faults, ...board.panel.faults], ended: code};
    lines = [];
    sentBytes = bytes;
    for (const response of waiting.splice(0)) {
        response.setHeader('X-State', encodeURIComponent(JSON.stringify(state)));
        response.end(Buffer.from(shown.pixels.buffer));
    }
}

function step() {
    const wall = performance.now(), ms = () => board.clock.nanos / 1e6 - boardBegin;
    if (wall - lookedAt > LINGER_MS || code !== undefined) return setTimeout(step, 50);
    if (wall - wallBegin > 500) { // how fast it is, and not to make up for a pause
        speed = ms() / (wall - wallBegin);
        [wallBegin, boardBegin] = [wall - Math.min(BEHIND_MS, Math.max(0, wall - wallBegin - ms())), board.clock.nanos / 1e6];
    }
    pressDue();
    if (ms() < performance.now() - wallBegin) code = board.run(SLICE_S);
    answer();
    return ms() < performance.now() - wallBegin ? setImmediate(step) : setTimeout(step, 2);
}

const routes = {
    'GET /': (_, response) => {
        response.setHeader('Content-Type', 'text/html; charset=utf-8');
        response.end(fs.readFileSync(new URL('handheld.html', import.meta.url)));
    },
    'GET /board': (_, response) => {
        response.setHeader('Content-Type', 'application/json');
        response.end(JSON.stringify(board.wires));
    },
    'GET /picture': (_, response) => {
        lookedAt = performance.now();
        waiting.push(response);
        response.on('close', () => waiting.includes(response) && waiting.splice(waiting.indexOf(response), 1));
    },
    'POST /button': (url, response) => {
        const name = url.searchParams.get('name'), held = url.searchParams.get('held') === '1';
        response.statusCode = name in board.wires.buttons ? 204 : 404;
        if (name in board.wires.buttons) queue.push({name, held});
        response.end();
    },
};

const server = http.createServer((request, response) => {
    const url = new URL(request.url, 'http://localhost'), route = routes[`${request.method} ${url.pathname}`];
    response.setHeader('Cache-Control', 'no-store');
    if (route) return route(url, response);
    response.statusCode = 404;
    return response.end('nothing here\n');
});
server.on('error', (error) => fail(`port ${port}: ${error.code === 'EADDRINUSE' ? 'taken; give another, PORT=' : error.message}`));
server.listen(+port, '127.0.0.1', () => {
    console.log(`${board.wires.name}: http://localhost:${server.address().port} (Ctrl-C ends it)`);
    step();
});
