// A fake micro:bit in place of the browser's `navigator.usb`: DAPLink with its stream and its serial line, flash, and a Python.
import { readFileSync } from 'node:fs';

const VECTORS = new URL('../../../shared/microbit-link/src/commonTest/resources/vectors/', import.meta.url);

/** A made-up file for V2, or for both boards: no MicroPython, but laid out like it. */
export const MICROPYTHON = hexFile('madeup-v2.hex');
export const MICROPYTHON_FOR_BOTH = hexFile('two-files.madeup-universal.hex');

function hexFile(name) {
  return { name, mimeType: 'application/octet-stream', buffer: readFileSync(new URL(name, VECTORS)) };
}

/**
 * The script that plugs it in, for `prepare` of `openPage`. `globalThis.board` is the board: `hex` is the text of the file that
 * it holds, `main` a program that came over the serial line, both null for none; `starts` counts how often it was started; `unplug()` and
 * `plugIn()` are what hands do, `print(line)` is what its program does.
 *
 * - `v1`: whether it is a V1, whose interface has no endpoints.
 * - `hasPython`: whether MicroPython is on it.
 * - `prints`: what a program prints when it is started.
 * - `loseAfter`: it is unplugged once that many bytes of the first file have come.
 * - `refuse`: the number that it says to each piece of a file.
 * - `pieceTakes`: milliseconds for each piece of a file.
 * - `isTaken`: whether another app has it.
 * - `isRemembered`: whether the browser knows it from before.
 */
export const plugIn = (options = {}) => `(${boardInPage})(${JSON.stringify(options)});`;

function boardInPage({
  v1 = false,
  hasPython = false,
  prints = [],
  loseAfter = Number.MAX_SAFE_INTEGER,
  refuse = 0,
  pieceTakes = 0,
  isTaken = false,
  isRemembered = false,
}) {
  const [VENDOR, PRODUCT, PACKET, PAYLOAD] = [0x0d28, 0x0204, 64, 62];
  const [INFO, UNIQUE_ID, SETTINGS, SET_BAUD, READ, WRITE, RESET, OPEN, CLOSE, STREAM] = [0x00, 0x80, 0x81, 0x82, 0x83, 0x84, 0x89, 0x8a, 0x8b, 0x8c];
  const END_OF_FILE = v1 ? 16 : 19;
  const CHECKSUM = v1 ? 18 : 21;
  const INTERNAL = 2;

  const board = { hex: null, main: null, starts: 0, questions: 0, pieces: 0, isPlugged: true, loseAfter, refuse, pieceTakes };
  globalThis.board = board;
  board.print = (line) => print(`${line}\r\n`);
  const text = (words) => [...new TextEncoder().encode(words)];
  const told = (words) => [words.length, ...text(words)];
  const dom = (name) => new DOMException(name, name);
  const pause = (milliseconds) => (milliseconds > 0 ? new Promise((resolve) => setTimeout(resolve, milliseconds)) : undefined);
  const view = (bytes) => new DataView(Uint8Array.from(bytes).buffer);

  let baudRate = v1 ? 9600 : 115200;
  let output = [];
  const print = (words) => {
    // What does not fit into the buffer is lost.
    output.push(...text(words).slice(0, 512 - output.length));
  };
  /** Python: a program runs, or one of the two prompts listens. */
  let mode = 'running';
  let input = [];
  let file = null;
  const FRIENDLY_BANNER = 'MicroPython v1.18; micro:bit with nRF52833\r\n>>> ';
  const start = () => {
    board.starts++;
    mode = 'running';
    input = [];
    output = [];
    for (const line of prints) setTimeout(() => mode === 'running' && (board.main ?? board.hex) && print(`${line}\r\n`), 100);
  };
  const enterRaw = () => {
    mode = 'raw';
    input = [];
    print('raw REPL; CTRL-B to exit\r\n>');
  };
  const fingerprint = (bytes) => {
    let [a, b] = [7, 1];
    for (const byte of bytes) {
      a = (a * 31 + byte) % 16777213;
      b = (b * 37 + byte) % 16777199;
    }
    return `${bytes.length} ${a} ${b}`;
  };
  const bytesOf = (literal) => [...literal.matchAll(/\\x([0-9a-f]{2})|[^\\']/g)].map(([whole, hex]) => (hex ? parseInt(hex, 16) : whole.charCodeAt(0)));
  const runLines = (lines) => {
    if (lines === '') {
      print('OK\r\nMPY: soft reboot\r\n');
      file = null;
      return enterRaw();
    }
    const written = /^f\.write\(b'(.*)'\)$/.exec(lines);
    let said = '';
    let error = '';
    if (/^f=open\('main\.py','wb'\)$/.test(lines)) file = [];
    else if (written && file) file.push(...bytesOf(written[1]));
    else if (lines === 'f.close()' && file) board.main = new TextDecoder().decode(Uint8Array.from(file));
    else if (lines.startsWith("f=open('main.py','rb')") && file) said = `${fingerprint(file)}\r\n`;
    else error = 'SyntaxError: invalid syntax\r\n';
    print(`OK${said}\u0004${error}\u0004>`);
  };
  const hearByte = (byte) => {
    if (!hasPython && board.hex === null) return;
    if (mode === 'running') {
      if (byte !== 3) return;
      mode = 'friendly';
      print(`Traceback (most recent call last):\r\n  File "main.py", line 3, in <module>\r\nKeyboardInterrupt: \r\n${FRIENDLY_BANNER}`);
    } else if (mode === 'friendly') {
      if (byte === 1) enterRaw();
      if (byte === 2) print(FRIENDLY_BANNER);
      if (byte === 3 || byte === 13) print('\r\n>>> ');
      if (byte === 4) {
        const before = output;
        start();
        output = before;
        print('MPY: soft reboot\r\n');
      }
    } else if (byte === 1) enterRaw();
    else if (byte === 2) {
      mode = 'friendly';
      print(FRIENDLY_BANNER);
    } else if (byte === 3) input = [];
    else if (byte === 4) {
      const lines = new TextDecoder().decode(Uint8Array.from(input)).trim();
      input = [];
      runLines(lines);
    } else input.push(byte);
  };

  /** A file on its way: null while no stream is open. */
  let stream = null;
  const isSound = (line) => {
    const bytes = (line.slice(1).match(/../g) ?? []).map((pair) => parseInt(pair, 16));
    return line.startsWith(':') && bytes.length > 4 && bytes.every((byte) => byte >= 0) && bytes.reduce((sum, byte) => sum + byte, 0) % 256 === 0;
  };
  const take = (bytes) => {
    if (stream === null || stream.isOver) return INTERNAL;
    board.pieces++;
    stream.bytes += bytes.length;
    // The first piece erases what was there.
    board.hex = null;
    board.main = null;
    if (stream.bytes >= board.loseAfter) {
      board.loseAfter = Number.MAX_SAFE_INTEGER;
      board.unplug();
      return INTERNAL;
    }
    if (board.refuse) return board.refuse;
    const lines = (stream.line + new TextDecoder().decode(Uint8Array.from(bytes))).split('\n');
    stream.line = lines.pop();
    for (const line of lines) {
      if (!isSound(line)) return CHECKSUM;
      stream.text += `${line}\n`;
      if (line.startsWith(':00000001')) {
        board.hex = stream.text;
        stream.isOver = true;
        return END_OF_FILE;
      }
    }
    return 0;
  };
  const answer = ([command, ...rest]) => {
    const bytes = rest.slice(1, 1 + Math.min(rest[0], PAYLOAD));
    if (command === INFO) return rest[0] === 1 ? told('Arm') : rest[0] === 9 && !v1 ? told('0257') : [0];
    if (command === UNIQUE_ID) return told(`${v1 ? '9900' : '9904'}36020052820c0e53b70b00000000000000`.padEnd(48, '7'));
    if (command === SETTINGS) return [0, 8, 16, 24].map((shift) => (baudRate >>> shift) & 255);
    if (command === SET_BAUD) {
      baudRate = rest[0] + rest[1] * 256 + rest[2] * 65536;
      start();
      return [1];
    }
    if (command === READ) {
      const taken = output.splice(0, PAYLOAD);
      return [taken.length, ...taken];
    }
    if (command === WRITE) {
      bytes.forEach(hearByte);
      return [1];
    }
    if (command === RESET) return [1];
    if (command === OPEN) {
      if (stream !== null || rest[0] !== 1) return [INTERNAL];
      stream = { text: '', line: '', bytes: 0, isOver: false };
      return [0];
    }
    if (command === CLOSE) {
      if (stream === null) return [INTERNAL];
      stream = null;
      start();
      return [0];
    }
    if (command === STREAM) return [take(bytes)];
    return [];
  };

  let answers = [];
  let waiting = null;
  const supply = () => {
    if (waiting === null || answers.length === 0) return;
    const { resolve } = waiting;
    waiting = null;
    resolve({ status: 'ok', data: view(answers.shift()) });
  };
  const refuseIfGone = () => {
    if (!board.isPlugged) throw dom('NetworkError');
  };
  const hear = async (packet) => {
    refuseIfGone();
    const bytes = [...new Uint8Array(packet.buffer ?? packet)];
    if (bytes.length !== PACKET) throw new Error(`A packet has ${bytes.length} bytes.`);
    await pause(bytes[0] === STREAM ? board.pieceTakes : 0);
    refuseIfGone();
    const padded = [bytes[0], ...answer(bytes)];
    while (padded.length < PACKET) padded.push(0);
    refuseIfGone();
    answers.push(padded);
    supply();
    return { status: 'ok', bytesWritten: PACKET };
  };
  board.unplug = () => {
    board.isPlugged = false;
    stream = null;
    answers = [];
    waiting?.reject(dom('NetworkError'));
    waiting = null;
  };
  board.plugIn = () => {
    board.isPlugged = true;
    device = deviceOf();
    if (granted.length > 0) granted = [device];
    start();
  };

  const endpoints = [
    { endpointNumber: 4, direction: 'out', type: 'bulk' },
    { endpointNumber: 5, direction: 'in', type: 'bulk' },
  ];
  // A board that was plugged in again is another device for the browser.
  const deviceOf = () => ({
    vendorId: VENDOR,
    productId: PRODUCT,
    productName: 'BBC micro:bit CMSIS-DAP',
    opened: false,
    configuration: null,
    async open() {
      if (this !== device) throw dom('NotFoundError');
      refuseIfGone();
      this.opened = true;
    },
    async close() {
      this.opened = false;
      waiting?.reject(dom('AbortError'));
      waiting = null;
    },
    async selectConfiguration() {
      const drive = { interfaceNumber: 0, alternate: { interfaceClass: 8, endpoints } };
      const old = { interfaceNumber: 4, alternate: { interfaceClass: 0xff, endpoints: [] } };
      const fresh = { interfaceNumber: 5, alternate: { interfaceClass: 0xff, endpoints } };
      this.configuration = { interfaces: v1 ? [drive, old] : [drive, old, fresh] };
    },
    async claimInterface(number) {
      if (isTaken) throw dom('NetworkError');
      if (number !== (v1 ? 4 : 5)) throw dom('NotFoundError');
    },
    transferIn(endpoint) {
      if (!board.isPlugged || v1 || endpoint !== 5 || waiting !== null) return Promise.reject(dom('NetworkError'));
      return new Promise((resolve, reject) => {
        waiting = { resolve, reject };
        supply();
      });
    },
    transferOut: (endpoint, packet) => (v1 || endpoint !== 4 ? Promise.reject(dom('NetworkError')) : hear(packet)),
    controlTransferOut: ({ requestType, recipient, request, value, index }, packet) =>
      v1 && requestType === 'class' && recipient === 'interface' && request === 9 && value === 0x200 && index === 4
        ? hear(packet)
        : Promise.reject(dom('NetworkError')),
    async controlTransferIn({ requestType, request, value, index }) {
      refuseIfGone();
      if (!v1 || requestType !== 'class' || request !== 1 || value !== 0x100 || index !== 4) throw dom('NetworkError');
      return { status: 'ok', data: view(answers.shift() ?? []) };
    },
    async clearHalt() {},
  });
  let device = deviceOf();
  let granted = isRemembered ? [device] : [];
  const usb = {
    getDevices: async () => (board.isPlugged ? granted : []),
    requestDevice: async ({ filters }) => {
      board.questions++;
      if (!navigator.userActivation.isActive) throw dom('SecurityError');
      if (!board.isPlugged || !filters.some((each) => each.vendorId === VENDOR && each.productId === PRODUCT)) throw dom('NotFoundError');
      granted = [device];
      return device;
    },
  };
  Object.defineProperty(navigator, 'usb', { value: usb, configurable: true });
}

/** The program `main.py` in the text of a `.hex`; null if there is none. */
export function mainIn(hex) {
  const memory = memoryOf(hex);
  for (const [address, byte] of memory) {
    // A file begins with its mark, the place of its end, and its name.
    if (byte !== 0xfe || address % 128 !== 0) continue;
    const chunk = (start) => Array.from({ length: 128 }, (_, place) => memory.get(start + place) ?? 0xff);
    const first = chunk(address);
    const name = Buffer.from(first.slice(3, 3 + first[2])).toString();
    if (name !== 'main.py') continue;
    const end = first[1];
    const bytes = [];
    let [place, current, index] = [3 + first[2], first, address];
    // The chunks of our files stand one behind the other, each with the number of the next at its end.
    while (current[127] !== 0xff) {
      bytes.push(...current.slice(place, 127));
      index += 128;
      current = chunk(index);
      place = 1;
    }
    bytes.push(...current.slice(place, end + 1));
    return Buffer.from(bytes).toString();
  }
  return null;
}

/** The bytes by address, of a plain hex or of all parts of a universal one. */
function memoryOf(hex) {
  const memory = new Map();
  let base = 0;
  for (const line of hex.split(/\r?\n/)) {
    const bytes = Buffer.from(line.slice(1), 'hex');
    if (bytes.length < 5) continue;
    const [count, type] = [bytes[0], bytes[3]];
    const data = bytes.subarray(4, 4 + count);
    if (type === 4) base = data.readUInt16BE(0) * 65536;
    if (type === 2) base = data.readUInt16BE(0) * 16;
    if (type === 0 || type === 0x0d) data.forEach((byte, place) => memory.set(base + bytes.readUInt16BE(1) + place, byte));
  }
  return memory;
}
