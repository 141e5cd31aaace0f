// A fake hub with Pybricks in place of the browser's `navigator.bluetooth`, `navigator.serial` and `navigator.usb`.

/**
 * The script that switches it on, for `prepare` of `openPage`. `globalThis.hub` is the hub: `slot` is the program that it
 * holds, null for none; `starts` counts how often a program was started, `pieces` what has come of programs; `loseConnection()` is what distance does.
 *
 * - `way`: 'bluetooth', 'serial' (firmware 4.1) or 'packets' (firmware 4.0).
 * - `prints`: what each program prints before it ends; none ends if `stays`.
 * - `loseAfter`: the connection is lost once that many bytes of the first download have come.
 * - `pieceTakes`: milliseconds for each piece of a program over Bluetooth, below 1000; other operations take 3.
 * - `messageBytes`: the longest command over Bluetooth.
 * - `lego`: whether it has LEGO's own firmware.
 */
export const switchOn = (options) => `(${hubInPage})(${JSON.stringify(options)});`;

function hubInPage({ way, prints = [], stays = false, loseAfter = Number.MAX_SAFE_INTEGER, pieceTakes = 3, messageBytes = 512, programBytes = 52_300, lego = false }) {
  const SERVICE = 'c5f50001-8280-46da-89f4-6d8051e4aeef';
  const COMMANDS = 'c5f50002-8280-46da-89f4-6d8051e4aeef';
  const CAPABILITIES = 'c5f50003-8280-46da-89f4-6d8051e4aeef';
  const LEGO_SERVICE = '0000fd02-0000-1000-8000-00805f9b34fb';
  const INFORMATION = '0000180a-0000-1000-8000-00805f9b34fb';
  const [VENDOR, PRODUCT] = [0x0694, 0x0009];
  const [RUNNING, DOWNLOADING] = [1 << 6, 1 << 13];
  const [OK, DOWNLOAD_STATE, NOT_ALLOWED, INVALID, BUSY] = [0, 0x0e, 0x13, 0x80, 0x81];

  const hub = { slot: null, starts: 0, stops: 0, pieces: 0, loseAfter, isLost: false };
  globalThis.hub = hub;

  const u32 = (number) => [0, 8, 16, 24].map((shift) => (number >>> shift) & 255);
  const numberAt = (bytes, place) => u32(0).reduce((sum, _, index) => sum + bytes[place + index] * 2 ** (8 * index), 0);
  const text = (words) => [...new TextEncoder().encode(words)];
  const dom = (name) => new DOMException(name, name);
  const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  const view = (bytes) => new DataView(Uint8Array.from(bytes).buffer);
  const longest = way === 'serial' ? 60 : way === 'packets' ? 63 : messageBytes;
  const values = {
    '2a00': text('Robo 7'),
    '2a26': text(way === 'serial' ? '4.1.0' : '4.0.1'),
    '2a28': text(way === 'serial' ? '1.6.0' : '1.5.0'),
    '2a50': [1, 0x97, 3, 0x81, 0, 0, 0],
    capabilities: [longest & 255, longest >> 8, ...u32(0x2b), ...u32(programBytes), 5],
  };

  /** What hears events. */
  let tell = null;
  let isRunning = false;
  let download = null;
  let closing = null;
  let loseConnection = () => undefined;
  hub.loseConnection = () => {
    hub.isLost = true;
    tell = null;
    download = null;
    loseConnection();
  };

  const tellStatus = () => tell?.([0, ...u32((isRunning ? RUNNING : 0) + (download ? DOWNLOADING : 0)), 0, 0]);
  const print = (line) => {
    const bytes = text(`${line}\r\n`);
    for (let place = 0; place < bytes.length; place += 19) tell?.([1, ...bytes.slice(place, place + 19)]);
  };
  const closeLater = () => {
    clearTimeout(closing);
    closing = setTimeout(() => {
      download = null;
      tellStatus();
    }, 1000);
  };
  const end = () => {
    isRunning = false;
    tellStatus();
  };
  const start = () => {
    if (isRunning) return BUSY;
    if (hub.slot === null) return INVALID;
    hub.starts++;
    isRunning = true;
    setTimeout(async () => {
      tellStatus();
      for (const line of prints) {
        await pause(50);
        print(line);
      }
      await pause(50);
      if (!stays) end();
    });
    return OK;
  };
  const stop = () => {
    hub.stops++;
    if (isRunning) {
      print('The program was stopped (SystemExit).');
      end();
    }
    return OK;
  };
  const size = (bytes) => {
    if (isRunning) return BUSY;
    if ((bytes === 0) !== (download === null)) return DOWNLOAD_STATE;
    hub.slot = bytes === 0 ? null : download.slice(0, bytes);
    download = bytes === 0 ? [] : null;
    if (bytes === 0) closeLater();
    else clearTimeout(closing);
    setTimeout(tellStatus);
    return OK;
  };
  const take = (offset, bytes) => {
    if (isRunning) return BUSY;
    if (download === null) return DOWNLOAD_STATE;
    if (offset + bytes.length > programBytes) return NOT_ALLOWED;
    hub.pieces++;
    bytes.forEach((byte, index) => {
      download[offset + index] = byte;
    });
    closeLater();
    return OK;
  };
  const command = ([kind, ...rest]) => {
    if (kind === 0) return stop();
    if (kind === 1) return start();
    if (kind === 3) return size(numberAt(rest, 0));
    if (kind === 4) return take(numberAt(rest, 0), rest.slice(4));
    return INVALID;
  };
  /** Whether the connection breaks with this command. */
  const isTooMuch = () => {
    if (download === null || download.length < hub.loseAfter) return false;
    hub.loseAfter = Number.MAX_SAFE_INTEGER;
    hub.loseConnection();
    return true;
  };

  const bluetoothHub = () => {
    const listeners = new Map();
    const on = (type, listener) => listeners.set(type, [...(listeners.get(type) ?? []), listener]);
    const emit = (type, event) => (listeners.get(type) ?? []).forEach((listener) => listener(event));
    let isBusy = false;
    const operation = async (work, takes = 3) => {
      if (!gatt.connected) throw dom('NetworkError');
      if (isBusy) throw dom('NetworkError'); // GATT operation already in progress.
      isBusy = true;
      await pause(takes);
      isBusy = false;
      if (!gatt.connected) throw dom('NetworkError');
      return work();
    };
    const readable = (value) => ({ readValue: () => operation(() => view(value)) });
    const commands = {
      addEventListener: on,
      writeValueWithResponse: (bytes) =>
        operation(
          () => {
            if (isTooMuch() || command([...bytes]) !== OK) throw dom('NetworkError');
          },
          bytes[0] === 4 ? pieceTakes : 3,
        ),
      stopNotifications: () => operation(() => undefined),
      startNotifications: () =>
        operation(() => {
          tell = (bytes) => emit('characteristicvaluechanged', { target: { value: view(bytes) } });
          setTimeout(tellStatus);
        }),
    };
    const service = (characteristics) => ({
      getCharacteristic: async (uuid) => {
        if (!characteristics[uuid]) throw dom('NotFoundError');
        return characteristics[uuid];
      },
    });
    const full = (short) => `0000${short}-0000-1000-8000-00805f9b34fb`;
    const services = {
      [INFORMATION]: service(Object.fromEntries(['2a26', '2a28', '2a50'].map((short) => [full(short), readable(values[short])]))),
      [lego ? LEGO_SERVICE : SERVICE]: service({ [COMMANDS]: commands, [CAPABILITIES]: readable(values.capabilities) }),
    };
    const gatt = {
      connected: false,
      async connect() {
        await pause(3);
        if (hub.isLost) throw dom('NetworkError');
        this.connected = true;
        return this;
      },
      disconnect() {
        if (!this.connected) return;
        this.connected = false;
        tell = null;
        emit('gattserverdisconnected', {});
      },
      async getPrimaryService(uuid) {
        if (!services[uuid]) throw dom('NotFoundError');
        return services[uuid];
      },
    };
    loseConnection = () => gatt.disconnect();
    return { name: 'Robo 7', gatt, addEventListener: on, isFor: ({ filters }) => filters.some((each) => each.services.some((uuid) => services[uuid])) };
  };

  /** What a message to the hub is answered with; `tag` is of serial ports only. */
  const answered = (bytes, tag) => [1, ...tag, ...u32(command(bytes))];

  const serialHub = () => {
    let control = null;
    let readable = null;
    let hears = false;
    let arrived = [];
    const send = (message) => {
      if (hears && !hub.isLost) control?.enqueue(Uint8Array.from(encode(message)));
    };
    const hear = ([kind, ...rest]) => {
      if (kind === 1) {
        tell = rest[0] ? (event) => send([2, ...event]) : null;
        tellStatus();
      }
      if (kind === 2 && !isTooMuch()) send(answered(rest.slice(1), [rest[0]]));
      if (kind === 3) send([3, ...rest.slice(0, 3), ...(rest[0] === 2 ? values.capabilities : (values[(rest[1] + 256 * rest[2]).toString(16)] ?? []))]);
    };
    const port = {
      getInfo: () => ({ usbVendorId: VENDOR, usbProductId: PRODUCT }),
      async open() {
        if (readable !== null) throw dom('InvalidStateError');
        if (hub.isLost) throw dom('NetworkError');
        readable = new ReadableStream({ start: (controller) => (control = controller) });
        port.writable = new WritableStream({
          write: (chunk) => {
            if (hub.isLost) throw dom('NetworkError');
            for (const byte of chunk) {
              arrived.push(byte);
              if (byte !== 2) continue;
              hear(decode(arrived));
              arrived = [];
            }
          },
        });
      },
      async setSignals({ dataTerminalReady }) {
        hears = dataTerminalReady;
      },
      get readable() {
        return readable;
      },
      writable: null,
      async close() {
        if (readable?.locked) throw new TypeError('The stream is locked.');
        readable = null;
        port.writable = null;
        tell = null;
      },
    };
    loseConnection = () => {
      const broken = control;
      readable = null;
      port.writable = null;
      broken?.error(dom('NetworkError'));
    };
    return port;
  };

  const usbHub = () => {
    let waiting = null;
    const arrived = [];
    const supply = () => {
      if (waiting === null || arrived.length === 0) return;
      const { resolve } = waiting;
      waiting = null;
      resolve({ status: 'ok', data: view(arrived.shift()) });
    };
    const send = (packet) => {
      arrived.push(packet);
      supply();
    };
    const endpoints = [
      { endpointNumber: 1, direction: 'in', type: 'bulk' },
      { endpointNumber: 2, direction: 'out', type: 'bulk' },
    ];
    const refuse = () => {
      if (hub.isLost) throw dom('NetworkError');
    };
    loseConnection = () => {
      waiting?.reject(dom('NetworkError'));
      waiting = null;
    };
    return {
      vendorId: VENDOR,
      productId: 0x0005,
      productName: 'EV3',
      opened: false,
      configuration: null,
      async open() {
        refuse();
        this.opened = true;
      },
      async close() {
        this.opened = false;
        waiting?.reject(dom('AbortError'));
        waiting = null;
      },
      async selectConfiguration() {
        const alternate = { interfaceClass: 0xff, interfaceSubclass: 0xc5, interfaceProtocol: 0xf5, endpoints };
        this.configuration = { interfaces: [{ interfaceNumber: 0, alternate }] };
      },
      async claimInterface() {},
      async controlTransferIn({ requestType, recipient, request, value }) {
        refuse();
        if (requestType !== 'class' || recipient !== 'interface') throw dom('NetworkError');
        return { status: 'ok', data: view(request === 2 ? values.capabilities : (values[value.toString(16)] ?? [])) };
      },
      transferIn() {
        if (hub.isLost || waiting !== null) return Promise.reject(dom('NetworkError'));
        return new Promise((resolve, reject) => {
          waiting = { resolve, reject };
          supply();
        });
      },
      async transferOut(endpoint, bytes) {
        refuse();
        const [kind, ...rest] = bytes;
        if (kind === 1) {
          tell = (event) => send([2, ...event]);
          tellStatus();
        } else if (!isTooMuch()) {
          send(answered(rest, []));
        }
        return { status: 'ok', bytesWritten: bytes.length };
      },
      async clearHalt() {},
    };
  };

  // The frames of LEGO's hubs: 0, 1 and 2 are escaped, blocks have at most 84 bytes, each byte is changed by 3, 2 ends one.
  const MOST = 84;
  function encode(bytes) {
    const out = [];
    let block = [];
    const flush = (code) => {
      out.push(code, ...block);
      block = [];
    };
    for (const byte of bytes) {
      if (byte <= 2) flush(byte * MOST + block.length + 3);
      else {
        block.push(byte);
        if (block.length === MOST) flush(255);
      }
    }
    flush(block.length + 3);
    return [...out.map((byte) => byte ^ 3), 2];
  }
  function decode(frame) {
    const bytes = frame.filter((byte, index) => !(byte === 1 && index === 0)).slice(0, -1).map((byte) => byte ^ 3);
    const out = [];
    for (let place = 0; place < bytes.length; ) {
      const code = bytes[place];
      const [value, length] = code === 255 ? [null, MOST] : [Math.floor((code - 3) / MOST), (code - 3) % MOST];
      out.push(...bytes.slice(place + 1, place + 1 + length));
      place += length + 1;
      if (value !== null && place < bytes.length) out.push(value);
    }
    return out;
  }

  const device = { bluetooth: bluetoothHub, serial: serialHub, packets: usbHub }[way]();
  let granted = [];
  const grant = async (isRightKind) => {
    if (!navigator.userActivation.isActive) throw dom('SecurityError');
    if (!isRightKind) throw dom('NotFoundError');
    granted = [device];
    return device;
  };
  const replace = (name, value) => Object.defineProperty(navigator, name, { value, configurable: true });
  replace('bluetooth', { requestDevice: (options) => grant(way === 'bluetooth' && device.isFor(options)) });
  replace('serial', {
    getPorts: async () => (way === 'serial' && !hub.isLost ? granted : []),
    requestPort: (options) => grant(way === 'serial' && options?.filters?.[0]?.usbVendorId === VENDOR),
  });
  replace('usb', {
    getDevices: async () => (way === 'packets' && !hub.isLost ? granted : []),
    requestDevice: (options) => grant(way === 'packets' && options.filters[0].classCode === 0xff),
  });
}
