// node program_test.mjs PAGE: the program of a built page, without a browser. TEXPLORER_MESSAGES names a file that gets the
// messages of both sides, one a line, for messages_test.py.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { deflateSync, inflateSync } from 'node:zlib';

import { Page, Program } from './program.mjs';

const CONTROL = 1;
const Z = 90;
const MIB = 1 << 20;
const SCHEME = 'texplorer:1:';

const source = new URL('../../', import.meta.url);
const bytesOf = (path) => readFileSync(new URL(path, source));
const page = await Page.load(process.argv[2]);

// A program after its tour.
function opened(options) {
    const program = new Program(page, options);
    program.draw();
    program.click('tour:Skip');
    return program;
}

// Numbers below a limit, the same ones in each run.
function random(seed) {
    return (limit) => {
        seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
        return (seed >>> 8) % limit;
    };
}

// The status after something was done: it must say something new.
function answerTo(program, act) {
    program.call('fileRefused', ...program.copyIn('the one before'));
    act();
    const { status } = program.spoken;
    assert.doesNotMatch(status, /the one before/, 'nothing was said');
    assert.notEqual(status, '');
    return status;
}

test('an idle window draws no frames', () => {
    const program = new Program(page);
    assert.equal(program.draw(), -1);
    assert.ok(program.count('panelTriangles') > 10);
    assert.equal(program.spoken.language, 'en');
    const frames = program.count('beginPanels');
    assert.equal(program.call('step'), -1);
    assert.ok(program.count('beginPanels') <= frames + 1);
    program.call('pointerMoved', 10, 10);
    assert.equal(program.draw(), -1);
    assert.ok(program.count('beginPanels') > frames + 1, 'it draws what has happened');
    assert.deepEqual(program.log, []);
});

test('a parameter is set, read and undone', () => {
    const program = opened();
    const wrapS = () => program.scene.textures[0].wrapS;
    assert.equal(wrapS(), 'GL_REPEAT');
    program.set('textures[0].wrapS', 'GL_CLAMP');
    program.draw();
    assert.equal(wrapS(), 'GL_CLAMP');
    program.press(Z, CONTROL);
    assert.equal(wrapS(), 'GL_REPEAT');
});

const lessons = readdirSync(new URL('assets/lessons', source), { withFileTypes: true })
    .filter((each) => each.isDirectory()).map((each) => each.name);
const LETTERS = { en: /[a-z]/i, zh_CN: /\p{Script=Han}/u, ru: /\p{Script=Cyrillic}/u };

for (const [language, letters] of Object.entries(LETTERS)) {
    test(`every lesson opens in ${language}`, () => {
        assert.ok(lessons.length > 20);
        const program = new Program(page, { language });
        const said = {};
        for (const name of lessons) {
            program.open(`lesson=${name}&step=1`);
            const { step, status, language: tag } = program.spoken;
            const { title, steps } = JSON.parse(bytesOf(`assets/lessons/${name}/lesson.json`));
            assert.equal(tag, language.replace('_', '-'));
            assert.deepEqual([step?.step, step?.steps], [0, steps.length], name);
            if (language === 'en')
                assert.equal(step.lesson, title);
            assert.match(step.text, letters);
            if (status)
                said[name] = status;
        }
        const { lines, ...others } = said; // WebGL's lines are 1 pixel wide
        assert.match(lines, letters);
        assert.deepEqual(others, {});
        assert.deepEqual(program.log, []);
    });
}

// Programs that several cases use, one after the other: a start takes longer than what is done then.
const programs = new Map();
function shared(name) {
    if (!programs.has(name))
        programs.set(name, opened());
    return programs.get(name);
}

// Messages. Each answer's form is examined here, and by messages_test.py with the schema.

const heard = [];
after(() => {
    if (process.env.TEXPLORER_MESSAGES)
        writeFileSync(process.env.TEXPLORER_MESSAGES, heard.map((each) => `${each}\n`).join(''));
});

function answerOf(program, message) {
    const answer = program.send(message);
    heard.push(program.posted.at(-1));
    assert.equal(answer.texplorer, 1);
    const others = Object.keys(answer).filter((each) => !['texplorer', 'id', 'error', 'scene', 'answers'].includes(each));
    assert.deepEqual(others, []);
    return answer;
}

const isChinese = ([path]) => path.includes('droid');

for (const [what, options, ask] of [['the language', { language: 'zh_CN' }, () => {}],
    ['a name', {}, (program) => program.call('fileRefused', ...program.copyIn('纹理.png'))]]) {
    test(`the Chinese font is fetched when ${what} needs it`, () => {
        const program = new Program({ ...page, fonts: page.fonts.filter((font) => !isChinese(font)) }, options);
        const fetchedBefore = program.count('fetchFont');
        ask(program);
        program.draw();
        assert.deepEqual([fetchedBefore, program.count('fetchFont')], [0, 1]);
        assert.equal(program.spoken.language, 'en');
        const textures = program.count('makeTexture');
        program.storage.write(...page.fonts.find(isChinese));
        program.call('refresh');
        program.draw();
        assert.equal(program.count('fetchFont'), 1);
        assert.equal(program.spoken.language, options.language ? 'zh-CN' : 'en');
        assert.ok(program.count('makeTexture') > textures);
    });
}

test('messages are obeyed', () => {
    const program = opened();
    const good = [
        { do: 'set', path: 'textures[0].wrapS', value: 'GL_CLAMP' }, { do: 'set', path: 'view.azimuth', value: '-12.5' },
        { do: 'load', scene: program.scene }, { do: 'load', scene: {} }, { do: 'load', scene: linkOf(program) },
        { do: 'open', address: 'lesson=wrap&step=2' }, { do: 'open', address: 'layout=embed' }, { do: 'open', address: '' },
        { do: 'read' },
    ];
    good.forEach((each, i) => {
        const id = i % 2 ? i : `number ${i}`;
        const message = { texplorer: 1, id, ...each };
        heard.push(JSON.stringify(message));
        const answer = answerOf(program, message);
        assert.equal(answer.error, undefined, JSON.stringify(each).slice(0, 200));
        assert.equal(answer.id, id);
        program.draw();
    });
    const { scene, answers } = answerOf(program, { texplorer: 1, do: 'read' });
    assert.equal(typeof scene.view, 'object');
    assert.ok(Array.isArray(answers));
});

test('messages tell of lessons', () => {
    const program = opened();
    program.open('lesson=first-texture&step=2');
    const before = program.posted.length;
    program.call('answer', 1);
    program.draw();
    program.call('goToStep', 3);
    program.draw();
    const events = program.posted.map((each) => JSON.parse(each));
    heard.push(...program.posted);
    assert.ok(before > 0);
    assert.deepEqual(events.map((each) => each.event), events.map(() => 'lesson'));
    assert.deepEqual([events[0].lesson, events[0].step], ['first-texture', 2]);
    assert.equal(events.findLast((each) => each.step === 2).answer, 2);
    assert.equal(events.at(-1).step, 4);
    for (const number of [-1, 7, 2 ** 31]) { // no answers and steps
        program.call('answer', number);
        program.call('goToStep', number);
    }
    program.draw();
    assert.equal(program.spoken.step.step, 3);
});

const nested = (depth, inner = 1) => `${'{"a":'.repeat(depth)}${inner}${'}'.repeat(depth)}`;
const whole = (rest) => `{"texplorer":1,"id":"a",${rest}}`;
const BAD = {
    'nothing': '',
    'no JSON': 'lesson=wrap',
    'a zero': '\0',
    'no object': '[]',
    'no UTF-8': Uint8Array.of(0x7b, 0x22, 0xff, 0x22, 0x3a, 0x31, 0x7d),
    'half a letter': whole('"do":"\\ud800"'),
    'a number beyond numbers': whole('"do":1e999'),
    'a version of the future': { texplorer: 2, do: 'read' },
    'no version': { do: 'read' },
    'nothing to do': { texplorer: 1 },
    'an unknown word': { texplorer: 1, do: 'quit' },
    'a number as a word': { texplorer: 1, do: 1 },
    'no value': { texplorer: 1, do: 'set', path: 'view.azimuth' },
    'a number as a value': { texplorer: 1, do: 'set', path: 'view.azimuth', value: 1 },
    'no such parameter': { texplorer: 1, do: 'set', path: 'view.azimut', value: '1' },
    'an index beyond the list': { texplorer: 1, do: 'set', path: 'textures[99999999999999999999].wrapS', value: 'GL_CLAMP' },
    'an index below 0': { texplorer: 1, do: 'set', path: 'textures[-1].wrapS', value: 'GL_CLAMP' },
    'no number': { texplorer: 1, do: 'set', path: 'view.azimuth', value: 'nan' },
    'no scene': { texplorer: 1, do: 'load' },
    'a list as a scene': { texplorer: 1, do: 'load', scene: [] },
    'a damaged link': { texplorer: 1, do: 'load', scene: `${SCHEME}AAAA` },
    'an unknown lesson': { texplorer: 1, do: 'open', address: 'lesson=first' },
    'a zero as an address': { texplorer: 1, do: 'open', address: '\0' },
    'a deep list': '['.repeat(MIB),
    'a deep object': nested(MIB),
    'the deepest scene': whole(`"do":"load","scene":${nested(31)}`),
    'a scene that is deeper': whole(`"do":"load","scene":${nested(32)}`),
    'a huge word': { texplorer: 1, do: 'x'.repeat(4 * MIB) },
    'a huge path': { texplorer: 1, do: 'set', path: `textures${'[0]'.repeat(MIB)}`, value: '1' },
    'a huge value': { texplorer: 1, do: 'set', path: 'view.azimuth', value: '1'.repeat(4 * MIB) },
    'many members': whole(`${'"a":1,'.repeat(MIB / 8)}"do":"a"`),
};

test('messages that are wrong are refused', () => {
    const program = shared('messages');
    const before = JSON.stringify(program.scene);
    for (const [name, message] of Object.entries(BAD)) {
        const answer = answerOf(program, message);
        assert.ok(typeof answer.error === 'string' && answer.error !== '', name);
        program.draw();
    }
    assert.equal(JSON.stringify(program.scene), before);
});

test('messages have a text or a number as their id', () => {
    const program = shared('messages');
    for (const id of ['', 'a', 0, -1.5, 2 ** 53, 'x'.repeat(MIB)])
        assert.equal(answerOf(program, { texplorer: 1, id, do: 'read' }).id, id);
    const others = [true, null, {}, ['a']].map((id) => answerOf(program, { texplorer: 1, id, do: 'read' }));
    assert.deepEqual(others.filter((each) => 'id' in each).map((each) => each.id), []);
});

// A link to the scene of a program, without the page's address.
function linkOf(program) {
    program.click('menu:File');
    program.click('menu:Copy link to this scene');
    return program.copied.slice(program.copied.indexOf('#') + 1);
}
const packed = (content) => SCHEME + deflateSync(content, { level: 1 }).toString('base64url');
const unpacked = (link) => inflateSync(Buffer.from(link.slice(SCHEME.length), 'base64url'));

test('a link leads back to its scene', () => {
    const program = opened();
    program.set('textures[0].wrapS', 'GL_CLAMP');
    program.draw();
    const link = linkOf(program);
    const other = opened();
    other.open(link);
    assert.deepEqual(other.scene, program.scene);
});

function refuses(program, address) {
    const status = answerTo(program, () => program.open(address));
    assert.match(status, /^The address can't be opened: /, String(address).slice(0, 4096));
}

test('an address that is noise is a message', () => {
    const program = shared('addresses');
    const next = random(1);
    const noise = Buffer.from(Uint8Array.from({ length: MIB }, () => next(256)));
    const addresses = [noise, noise.toString('base64url'), SCHEME + noise.toString('base64url'), SCHEME + 'A'.repeat(MIB / 2),
        '\0', '#', 'texplorer:', 'texplorer:2:AAAA', 'lesson=../wrap', 'lesson=%00', '&'.repeat(MIB), 'lesson=wrap&step=0',
        'lesson=wrap&step=99999999999999999999', 'step=1', 'layout=', 'https://example.org/#'.repeat(1000)];
    for (const address of addresses)
        refuses(program, address);
    assert.equal(program.spoken.step, undefined);
});

test('a message about an address can be read', () => {
    const program = shared('addresses');
    const status = answerTo(program, () => program.open(`lesson=${'x'.repeat(MIB)}`));
    assert.ok(status.length < 4096, `it has ${status.length} letters`);
});

test('a damaged link is a message', () => {
    const program = shared('addresses');
    const link = linkOf(program);
    const next = random(2);
    const refused = (address) => refuses(program, address);
    for (let i = 0; i < 30; ++i)
        refused(link.slice(0, SCHEME.length + next(link.length - SCHEME.length)));
    for (let i = 0; i < 30; ++i) {
        const bytes = Buffer.from(link.slice(SCHEME.length), 'base64url');
        bytes[next(bytes.length)] ^= 1 << next(8);
        refused(SCHEME + bytes.toString('base64url'));
    }
    const json = unpacked(link);
    for (let i = 0; i < 30; ++i)
        refused(packed(json.subarray(0, next(json.length - 2))));
    const deep = ['['.repeat(MIB), '{"a":'.repeat(MIB), `{"view":${'['.repeat(MIB)}`];
    for (const content of [Buffer.alloc(100 * MIB, 32), ...deep, '', 'null'])
        refused(packed(content));
    for (let i = 0; i < 60; ++i) { // it may still be a scene
        const bytes = Buffer.from(json);
        bytes[next(bytes.length)] ^= 1 << next(8);
        program.open(packed(bytes));
    }
    assert.equal(typeof program.scene.view, 'object');
});

// A grey JPEG file of 8 × 8 pixels.
const JPEG = Buffer.from(`
    /9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABsSFBcUERsXFhceHBsgKEIrKCUlKFE6PTBCYFVlZF9VXVtqeJmBanGQc1tdhbWGkJ6jq62rZ4C8ybqm
    x5moq6T/wAALCAAIAAgBAREA/8QAFAABAAAAAAAAAAAAAAAAAAAAAf/EABcQAAMBAAAAAAAAAAAAAAAAAAADBWL/2gAIAQEAAD8AFwsH/9k=`, 'base64');
const IMAGES = {
    jpg: JPEG,
    bmp: bytesOf('assets/lessons/textured-cube/uv.bmp'),
    tga: bytesOf('assets/lessons/textured-cube/top-down.tga'),
    dds: bytesOf('assets/lessons/dds/dxt1.dds'),
    png: bytesOf('tests/fixtures/released/0.1.0/lesson/image.png'),
};

for (const [kind, image] of Object.entries(IMAGES)) {
    test(`an image that ends early is a message: ${kind}`, () => {
        const program = shared('images');
        const before = program.scene.textures[0].file;
        for (const share of [0, 0.02, 0.1, 0.3, 0.5]) {
            const name = `${share}.${kind}`;
            const status = answerTo(program, () => program.give({ [name]: image.subarray(0, image.length * share) }));
            assert.ok(status.startsWith(`${name}: `), status);
        }
        assert.equal(program.scene.textures[0].file, before);
        const next = random(3);
        for (let i = 0; i < 10; ++i) { // it may still be an image
            const bytes = Buffer.from(image);
            bytes[next(Math.min(bytes.length, 200))] ^= 1 << next(8);
            program.give({ [`damaged-${i}.${kind}`]: bytes });
        }
        program.give({ [`whole.${kind}`]: image });
        assert.equal(program.scene.textures[0].file, `whole.${kind}`);
        assert.deepEqual(program.log, []);
    });
}

test('a file of any name stays in its folder', () => {
    const program = opened();
    for (const name of ['../../home/config/a.bmp', '/usr/b.bmp', '..', '.', '', 'c\0.bmp', 'd/', '~', 'x'.repeat(5000)])
        program.give({ [name]: IMAGES.bmp });
    const paths = ['/home', '/usr', '/tmp', '/downloads'].flatMap((folder) => [...program.files(folder).keys()]);
    const own = /^\/(home\/(config|state)\/texplorer|usr\/share\/fonts)\//;
    assert.deepEqual(paths.filter((each) => !own.test(each)), []);
    assert.notEqual(program.files('/given').size, 0);
    assert.deepEqual([...program.storage.root.dir.contents.keys()].sort(), ['downloads', 'given', 'home', 'tmp', 'usr']);
});

test('memory does not grow with edits', () => {
    const program = opened();
    const next = random(4);
    const edits = {
        'textures[0].wrapS': ['GL_REPEAT', 'GL_CLAMP', 'GL_CLAMP_TO_EDGE'],
        'textures[0].minFilter': ['GL_NEAREST', 'GL_LINEAR'],
        'textures[0].pattern': ['checker', 'gradient'],
        'view.azimuth': ['10', '20', '30'],
    };
    const taken = [];
    for (let i = 1; i <= 300; ++i) {
        const path = Object.keys(edits)[next(4)];
        assert.equal(program.set(path, edits[path][next(edits[path].length)]).error, undefined);
        program.draw();
        if (i % 100 === 0)
            taken.push([program.used, program.memory]);
    }
    const grown = [0, 1].map((i) => taken[2][i] - taken[0][i]);
    assert.ok(grown[0] < 6 * MIB, `${grown[0]} bytes more are in use`); // undo steps are among them, of some KB each
    assert.ok(grown[1] < 6 * MIB, `the memory has grown by ${grown[1]} bytes`);
});

// Storage.

const SETTINGS = '/home/config/texplorer/settings.json';
const textOf = (bytes) => new TextDecoder().decode(bytes);
const settingsOf = (program) => JSON.parse(textOf(program.files('/home').get(SETTINGS)));
const DRAFT = /^\/home\/state\/texplorer\/unsaved\/.*\.scene$/;
const draftsOf = (program) => [...program.files('/home')].filter(([path]) => DRAFT.test(path));

test('settings and unsaved work are stored', () => {
    const program = opened({ size: [1280, 800] });
    assert.equal(settingsOf(program).hasSeenTour, true);
    assert.deepEqual(draftsOf(program), []);
    program.set('textures[0].wrapT', 'GL_CLAMP'); // by the page around it
    program.draw();
    program.call('store');
    assert.deepEqual(draftsOf(program), []);
    program.click('textures[0].wrapS=GL_CLAMP');
    program.call('store');
    const drafts = draftsOf(program);
    assert.equal(drafts.length, 1);
    assert.match(textOf(drafts[0][1]), /GL_CLAMP/);
});

function answerAQuestion(program) {
    program.open('lesson=first-texture&step=2');
    program.call('answer', 1);
    program.draw();
    assert.equal(program.spoken.status, '');
    assert.notEqual(settingsOf(program).lessons['first-texture'], undefined);
}

test('settings are stored again', () => answerAQuestion(opened()));

test('settings are stored by the next page', () => {
    const program = new Program(page, { storage: opened().storage });
    assert.equal(program.find('tour:Skip'), null);
    assert.notEqual(program.find('view'), null);
    answerAQuestion(program);
});

// Unsaved work that the next page has restored.
function restored(program) {
    program.call('store');
    const next = new Program(page, { storage: program.storage });
    next.click('restore:restore');
    return next;
}

test('unsaved work is offered by the next page, with its image', () => {
    const program = opened();
    program.give({ 'a.bmp': IMAGES.bmp });
    program.set('textures[0].wrapS', 'GL_CLAMP');
    program.draw();
    const next = restored(program);
    assert.deepEqual(next.scene, program.scene);
    assert.doesNotMatch(next.spoken.status, /a\.bmp/); // it was found
});

test('an image is stored in place of an older one of its name', () => {
    const first = opened();
    first.give({ 'same name': IMAGES.bmp }); // the content says what it is
    first.call('store');
    const program = new Program(page, { storage: first.storage });
    program.give({ 'same name': IMAGES.tga });
    const { file } = program.scene.textures[0];
    const stored = program.files('/given').get(`/given/${file}`);
    assert.ok(stored, file);
    assert.equal(Buffer.compare(stored, IMAGES.tga), 0, 'it is another image');
});
