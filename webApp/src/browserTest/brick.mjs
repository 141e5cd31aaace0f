// A fake tower with a simulated RCX behind it, in place of the browser's `navigator.serial` and `navigator.usb`.

/**
 * The script that plugs it in, for `prepare` of `openPage`. `globalThis.brick` is the RCX: `program` is the image that it
 * holds, null for none.
 *
 * - `kind`: 'serial' or 'usb'.
 * - `firmware`: 'lejos', 'lego' or 'none'.
 * - `isOn`: whether the brick answers.
 * - `loss`: the share of bytes that are lost on the way, in both directions.
 * - `damage`: whether each lost byte ends the stream of a serial port with a ParityError.
 * - `remembered`: whether the pupil has allowed the tower before.
 * - `answerAfter`: milliseconds until the brick answers.
 * - `isQuick`: whether the short waits of the protocol pass at once.
 * - `unplugAfterBlocks`: the tower is unplugged once the brick has that many blocks.
 */
export const plugIn = (options) => `(${plug})(${JSON.stringify(options)});`;

function plug({
  kind,
  firmware = 'lejos',
  isOn = true,
  loss = 0,
  damage = false,
  remembered = false,
  answerAfter = 0,
  isQuick = false,
  unplugAfterBlocks = Number.MAX_SAFE_INTEGER,
}) {
  const MAGIC = [0xca, 0xf6];
  const LAST = 0;
  const later = globalThis.setTimeout.bind(globalThis);

  // The longest wait between two looks at what has come, in milliseconds.
  const SHORT_WAIT = 25;
  if (isQuick) {
    const forget = globalThis.clearTimeout.bind(globalThis);
    const pending = new Map();
    const channel = new MessageChannel();
    channel.port1.onmessage = ({ data }) => {
      const action = pending.get(data);
      pending.delete(data);
      action?.();
    };
    let number = 0;
    globalThis.setTimeout = (action, milliseconds = 0, ...rest) => {
      if (milliseconds > SHORT_WAIT) return later(action, milliseconds, ...rest);
      number -= 1;
      pending.set(number, () => action(...rest));
      channel.port2.postMessage(number);
      return number;
    };
    globalThis.clearTimeout = (id) => (pending.delete(id) ? undefined : forget(id));
  }

  // The same in every run.
  let seed = 12345;
  const random = () => {
    seed = (seed * 1103515245 + 12345) % 2147483648;
    return seed / 2147483648;
  };

  const brick = { firmware, isOn, loss, program: null, firmwareBytes: null, blocks: 0, damages: 0, unplugged: false };
  globalThis.brick = brick;
  let download = null;
  let latest = null;

  /** The answer to the message `bytes`, null for none. */
  const answerTo = ([opcode, ...rest]) => {
    const kind = opcode & 0xf7;
    const reply = (...more) => [~opcode & 0xff, ...more];
    if (kind === 0x10) return reply();
    if (kind === 0x15) return reply(0, 3, 0, 1, ...(brick.firmware === 'lego' ? [0, 3, 3, 2] : [0, 0, 0, 0]));
    if (kind === 0x30) return brick.firmware === 'lego' ? reply(0x28, 0x23) : null;
    if (kind === 0x65) {
      Object.assign(brick, { firmware: 'none', program: null, firmwareBytes: null });
      download = null;
      return reply();
    }
    if (brick.firmware === 'none') return romAnswer(opcode, rest, reply);
    return brick.firmware === 'lejos' ? lejosAnswer(opcode, rest, reply) : null;
  };

  const romAnswer = (opcode, rest, reply) => {
    const kind = opcode & 0xf7;
    if (kind === 0x75) {
      download = { bytes: [], sum: rest[2] + 256 * rest[3] };
      return reply(0);
    }
    if (kind === 0x45) {
      if (download === null) return reply(1);
      const block = blockOf(rest);
      if (!block.isRight) return reply(3);
      if (opcode !== latest) download.bytes.push(...block.data);
      brick.blocks++;
      return reply(0);
    }
    if (kind === 0xa5) {
      const bytes = download?.bytes ?? [];
      const sum = bytes.slice(0, 0xcc00 - 0x8000).reduce((sum, byte) => (sum + byte) % 65536, 0);
      if (sum !== download?.sum || !String.fromCharCode(...bytes).includes('Do you byte, when I knock?')) return null;
      Object.assign(brick, { firmware: 'lejos', firmwareBytes: bytes });
      download = null;
      return reply(...Array.from('Just a bit off the block!', (letter) => letter.charCodeAt(0)));
    }
    return null;
  };

  const lejosAnswer = (opcode, rest, reply) => {
    const kind = opcode & 0xf7;
    if (kind === 0x12) {
      const isSecond = download !== null;
      brick.program = null;
      download = isSecond ? null : { bytes: [], next: 1, latest: opcode };
      return isSecond ? null : reply(...MAGIC);
    }
    if (kind === 0x45) {
      if (download === null) return reply(1);
      const block = blockOf(rest);
      if (!block.isRight) {
        download = null;
        return reply(3);
      }
      if (opcode === download.latest) return reply(0);
      download.latest = opcode;
      brick.blocks++;
      if (block.number !== LAST && block.number !== download.next) {
        download = null;
        return reply(0);
      }
      if (block.number === LAST && download.next === 1) return reply(0);
      download.bytes.push(...block.data);
      download.next++;
      if (block.number === LAST) {
        if (MAGIC.every((byte, place) => download.bytes[place] === byte)) brick.program = download.bytes;
        download = null;
      }
      return reply(0);
    }
    download = null;
    return null;
  };

  const blockOf = (rest) => {
    const size = rest[2] + 256 * rest[3];
    const data = rest.slice(4, 4 + size);
    const sum = data.reduce((sum, byte) => (sum + byte) % 256, 0);
    return { number: rest[0] + 256 * rest[1], data, isRight: data.length === size && rest[4 + size] === sum };
  };

  const framed = (bytes) => {
    const sum = bytes.reduce((sum, byte) => (sum + byte) % 256, 0);
    return [0x55, 0xff, 0x00, ...[...bytes, sum].flatMap((byte) => [byte, ~byte & 0xff])];
  };

  /** The message in `bytes`, null if it is none or damaged. */
  const messageIn = (bytes) => {
    const start = bytes.findIndex((_, at) => bytes[at] === 0x55 && bytes[at + 1] === 0xff && bytes[at + 2] === 0x00);
    if (start < 0) return null;
    const pairs = bytes.slice(start + 3);
    if (pairs.length < 4 || pairs.length % 2 !== 0) return null;
    const message = [];
    for (let at = 0; at < pairs.length; at += 2) {
      if ((pairs[at] ^ pairs[at + 1]) !== 0xff) return null;
      message.push(pairs[at]);
    }
    const sum = message.pop();
    return message.reduce((sum, byte) => (sum + byte) % 256, 0) === sum ? message : null;
  };

  const lossy = (bytes) => bytes.filter(() => random() >= brick.loss);

  /** Takes what the tower sends, and returns what it receives. */
  const hear = (bytes) => {
    if (!brick.isOn) return [];
    const message = messageIn(lossy(bytes));
    if (message === null) return [];
    const answer = answerTo(message);
    latest = message[0];
    if (brick.blocks >= unplugAfterBlocks) unplug();
    return answer === null ? [] : lossy(framed(answer));
  };

  /** Hands `bytes` over to the tower when the brick answers. */
  const answer = (bytes) => (answerAfter > 0 ? later(() => deliver(bytes), answerAfter) : deliver(bytes));

  /** What the robot sends by itself. */
  brick.say = (bytes) => deliver(framed(bytes));

  const dom = (name) => new DOMException(name, name);
  let deliver = () => undefined;
  let unplug = () => undefined;
  const needsClick = () => {
    if (!navigator.userActivation.isActive) throw dom('SecurityError');
  };

  const serialPort = () => {
    let readable = null;
    let control = null;
    let isOpen = false;
    const newStream = () => {
      readable = new ReadableStream({
        start: (controller) => {
          control = controller;
        },
      });
    };
    deliver = (bytes) => {
      if (bytes.length > 0 && !brick.unplugged) control.enqueue(Uint8Array.from(bytes));
    };
    const port = {
      getInfo: () => ({ usbVendorId: 0x067b, usbProductId: 0x2303 }),
      async open({ baudRate, dataBits, stopBits, parity, bufferSize }) {
        if (isOpen) throw dom('InvalidStateError');
        if (brick.unplugged) throw dom('NetworkError');
        const isRight = baudRate === 2400 && dataBits === 8 && stopBits === 1 && parity === 'odd' && bufferSize > 500;
        if (!isRight) throw new TypeError('These are not the settings of a tower.');
        isOpen = true;
        newStream();
        this.writable = new WritableStream({
          write: (chunk) => {
            if (brick.unplugged) throw dom('NetworkError');
            const bytes = Array.from(chunk);
            const echo = lossy(bytes);
            const answered = hear(bytes);
            deliver(echo);
            if (damage && echo.length < bytes.length) {
              // The bytes before are read, the stream ends, and the port offers another.
              brick.damages++;
              later(() => {
                if (brick.unplugged || readable === null) return;
                const broken = control;
                newStream();
                broken.error(dom('ParityError'));
                later(() => deliver(answered), 5);
              }, 5);
            } else {
              answer(answered);
            }
          },
        });
      },
      get readable() {
        return readable;
      },
      writable: null,
      async close() {
        if (readable?.locked) throw new TypeError('The stream is locked.');
        isOpen = false;
        readable = null;
        this.writable = null;
      },
    };
    unplug = () => {
      brick.unplugged = true;
      const broken = control;
      readable = null;
      port.writable = null;
      broken?.error(dom('NetworkError'));
    };
    return port;
  };

  const usbTower = () => {
    let waiting = null;
    const arrived = [];
    const supply = () => {
      if (waiting === null || arrived.length === 0) return;
      const data = new DataView(Uint8Array.from(arrived.splice(0, 8)).buffer);
      const { resolve } = waiting;
      waiting = null;
      resolve({ status: 'ok', data });
    };
    // The tower swallows the first byte of what it receives.
    deliver = (bytes) => {
      if (brick.unplugged) return;
      arrived.push(...bytes.slice(1));
      supply();
    };
    const endpoints = [
      { endpointNumber: 1, direction: 'in' },
      { endpointNumber: 2, direction: 'out' },
    ];
    const tower = {
      vendorId: 0x0694,
      productId: 0x0001,
      productName: 'LEGO USB Tower',
      opened: false,
      claimed: false,
      asked: [],
      configuration: null,
      async open() {
        if (brick.unplugged) throw dom('NotFoundError');
        this.opened = true;
      },
      async close() {
        this.opened = false;
        waiting?.reject(dom('AbortError'));
        waiting = null;
      },
      async selectConfiguration(number) {
        if (number !== 1) throw dom('NotFoundError');
        this.configuration = { interfaces: [{ alternate: { endpoints } }] };
      },
      async claimInterface(number) {
        if (brick.heldByDriver) throw dom('NetworkError');
        this.claimed = number === 0;
      },
      async controlTransferIn({ requestType, recipient, request, value, index }, length) {
        if (!this.opened || requestType !== 'vendor' || recipient !== 'device' || index !== 0) throw dom('NetworkError');
        this.asked.push(request);
        return { status: 'ok', data: new DataView(new ArrayBuffer(length)) };
      },
      transferIn(endpoint, length) {
        if (!this.claimed || endpoint !== 1 || length !== 8 || waiting !== null) return Promise.reject(dom('NetworkError'));
        return new Promise((resolve, reject) => {
          waiting = { resolve, reject };
          supply();
        });
      },
      async transferOut(endpoint, bytes) {
        if (!this.claimed || endpoint !== 2 || brick.unplugged) throw dom('NetworkError');
        answer(hear(Array.from(bytes)));
        return { status: 'ok', bytesWritten: bytes.length };
      },
      async clearHalt() {},
    };
    unplug = () => {
      brick.unplugged = true;
      waiting?.reject(dom('NetworkError'));
      waiting = null;
    };
    return tower;
  };

  const device = kind === 'serial' ? serialPort() : usbTower();
  brick.unplug = () => unplug();
  brick.plugIn = () => {
    brick.unplugged = false;
    brick.blocks = Number.MIN_SAFE_INTEGER;
  };
  brick.device = device;
  let granted = remembered ? [device] : [];
  const grant = async (isRightKind) => {
    needsClick();
    if (!isRightKind || brick.refuses) throw dom('NotFoundError');
    granted = [device];
    return device;
  };
  const replace = (name, value) => Object.defineProperty(navigator, name, { value, configurable: true });
  replace('serial', {
    getPorts: async () => (kind === 'serial' && !brick.unplugged ? granted : []),
    requestPort: () => grant(kind === 'serial'),
  });
  replace('usb', {
    getDevices: async () => (kind === 'usb' && !brick.unplugged ? granted : []),
    requestDevice: ({ filters }) => grant(kind === 'usb' && filters[0].vendorId === 0x0694 && filters[0].productId === 1),
  });
}
