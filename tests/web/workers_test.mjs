// node workers_test.mjs PAGE: pictures and files that the program of a built page gets from workers. Here they work when the
// test lets them.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { Page, Program } from './program.mjs';

const page = await Page.load(process.argv[2]);
const image = readFileSync(new URL('../../assets/lessons/textured-cube/uv.bmp', import.meta.url));

// A program that shows the reference alone, whose first picture is asked for.
function opened(options) {
    const program = new Program(page, { size: [1280, 800], ...options }); // which has room for the choice of renderers
    program.draw();
    program.click('tour:Skip');
    program.click('renderer:Reference');
    return program;
}

// The same, after its first picture. Workers seem to need no time.
function drawn() {
    const program = opened();
    program.wait();
    program.pictures.length = 0;
    return program;
}

function turn(program, azimuth) {
    program.set('view.azimuth', String(azimuth));
    program.draw();
}

test('a worker draws what the reference shows', () => {
    const program = drawn();
    const shown = program.count('makeTexture');
    turn(program, 30);
    assert.equal(program.asked.length, 1);
    program.wait();
    assert.equal(program.count('makeTexture'), shown + 1);
    const [{ pixels, width, height, problems }] = program.pictures;
    assert.deepEqual(problems, []);
    assert.equal(pixels.length, width * height * 4);
    const background = program.scene.view.background.slice(0, 3).map((each) => Math.round(each * 255));
    assert.deepEqual([...pixels.subarray(0, 3)], background);
    const middle = 4 * (width * Math.floor(height / 2) + Math.floor(width / 2));
    assert.notDeepEqual([...pixels.subarray(middle, middle + 3)], background);
    assert.deepEqual(program.log, []);
});

test('the window asks for the newest picture only', () => {
    const program = drawn();
    for (const azimuth of [10, 20, 30, 40])
        turn(program, azimuth);
    program.wait();
    assert.equal(program.pictures.length, 2);
    const [first, last] = program.pictures;
    assert.equal(first.width, last.width);
    assert.notDeepEqual(first.pixels, last.pixels);
});

test('of a picture that takes long a coarse one comes first', () => {
    const program = opened();
    program.milliseconds = 1000;
    program.wait();
    const { width } = program.pictures.at(-1);
    const widths = () => program.pictures.splice(0).map((each) => each.width);
    const coarse = Math.floor(width / 8);
    program.pictures.length = 0;
    turn(program, 10);
    program.wait();
    assert.deepEqual(widths(), [coarse, width]);
    turn(program, 20);
    turn(program, 30); // while the coarse one is drawn
    program.wait();
    assert.deepEqual(widths(), [coarse, coarse, width]);
});

test('a worker has the files of the scene', () => {
    const program = drawn();
    program.give({ 'given.bmp': image });
    program.wait();
    const given = program.pictures.at(-1);
    assert.equal(program.scene.textures[0].file, 'given.bmp');
    assert.deepEqual(given.problems, []);
    program.set('textures[0].source', 'pattern');
    program.draw();
    program.wait();
    assert.notDeepEqual(program.pictures.at(-1).pixels, given.pixels);
    program.send({ texplorer: 1, do: 'load', scene: { ...program.scene, textures: [{ source: 'file', file: 'missing.bmp' }] } });
    program.draw();
    program.wait();
    assert.match(JSON.stringify(program.pictures.at(-1).problems), /missing\.bmp/);
});

test('a worker that ends is replaced', () => {
    const program = opened();
    program.asked.length = 0;
    const [worker] = program.workers.keys();
    program.call('workerEnded', worker, ...program.copyIn('unreachable'));
    program.draw();
    assert.match(program.spoken.status, /unreachable/);
    assert.equal(program.workers.has(worker), false);
    turn(program, 10);
    program.wait();
    assert.ok(program.pictures.length > 0);
    assert.equal(program.workers.size, 1);
    assert.equal(program.spoken.status, '');
});

test('a picture of other texels is not shown', () => {
    const program = drawn();
    turn(program, 10);
    program.set('textures[0].pattern', 'gradient');
    program.draw();
    const shown = program.count('makeTexture');
    program.asked.shift()();
    program.draw();
    assert.equal(program.count('makeTexture'), shown, 'the answer is that of the pattern before');
    program.wait();
    assert.ok(program.count('makeTexture') > shown);
});

test('a worker that draws other texels for long is replaced', async () => {
    const program = drawn();
    turn(program, 10);
    const [worker] = program.workers.keys();
    program.set('textures[0].pattern', 'gradient');
    program.draw();
    while (program.workers.has(worker)) { // as long as another one would need to start
        await new Promise((resolve) => { setTimeout(resolve, 50); });
        program.draw();
    }
    program.wait();
    assert.equal(program.pictures.length, 1);
});

test('a worker that is not needed ends', () => {
    const program = opened();
    program.wait();
    assert.equal(program.workers.size, 1);
    program.click('renderer:Shader');
    program.wait();
    assert.equal(program.workers.size, 0);
});

test('a browser without workers is named', () => {
    const program = opened({ withoutWorkers: true });
    assert.equal(program.asked.length, 0);
    assert.equal(program.workers.size, 0);
    assert.match(program.spoken.status, /worker/);
    turn(program, 10); // it does not stop
    assert.deepEqual(program.log, []);
});

// Begins to record an animation.
function record(program) {
    program.set('models[0].spin', '0,90,0');
    program.draw();
    for (const name of ['menu:File', 'menu:Record animation…', 'record:GIF', 'record:choose'])
        program.click(name);
}

// Lets the workers do what they are asked now: a scene that moves asks for more without an end.
function work(program) {
    for (let rest = program.asked.length; rest > 0; --rest) {
        program.asked.shift()();
        program.draw();
    }
}

test('a file is made in a copy of the program', () => {
    const program = drawn();
    record(program);
    turn(program, 30); // not in the file: the window goes on
    work(program);
    const [{ name, bytes }] = program.saved;
    assert.match(name, /\.gif$/);
    assert.equal(Buffer.from(bytes.subarray(0, 6)).toString(), 'GIF89a');
    assert.ok(program.shares.length > 2);
    assert.ok(program.shares.every((share, i) => share <= 1 && (i === 0 || share >= program.shares[i - 1])));
    assert.match(program.spoken.status, /Written/);
    assert.deepEqual(program.log, []);

    const alone = opened({ withoutWorkers: true });
    record(alone);
    assert.deepEqual(alone.saved, program.saved);
});

test('a file that is cancelled is not made', () => {
    const program = drawn();
    record(program);
    program.click('cancel:writing');
    work(program);
    assert.deepEqual(program.saved, []);
});

test('a file whose worker ends is named', () => {
    const program = drawn();
    record(program);
    program.call('workerEnded', Math.max(...program.workers.keys()), ...program.copyIn('no memory'));
    program.draw();
    work(program);
    assert.deepEqual(program.saved, []);
    assert.match(program.spoken.status, /no memory/);
});

test('a sheet is made in a copy of the program', () => {
    const program = drawn();
    for (const name of ['menu:File', 'menu:Sheet of variations…', 'sheet:save', 'sheet file:choose'])
        program.click(name);
    work(program);
    assert.match(program.spoken.status, /Written/);
    const [{ name, bytes }] = program.saved;
    assert.match(name, /sheet\.png$/);
    assert.equal(Buffer.from(bytes.subarray(1, 4)).toString(), 'PNG');
});
