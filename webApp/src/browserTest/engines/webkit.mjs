// WebKitGTK's MiniBrowser, driven by its WebDriver (W3C, over HTTP).
import { spawn } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { createServer } from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { startDisplay } from './display.mjs';
import { ended } from './ended.mjs';
import { EnginePage } from './engine-page.mjs';

/** Minimal machines have no other locale. WebKit reports it to pages as `C`. */
const LANG = 'C.UTF-8';

/** Opens an empty page of this size in a new WebKit. `binary` is the browser, `driver` its WebDriver. */
export async function openWebKit({ driver, binary }, { width, height }) {
  const home = await mkdtemp(path.join(os.tmpdir(), 'robotran-webkit-'));
  const display = await startDisplay();
  const port = await freePort();
  const { PATH } = process.env;
  const browser = spawn(driver, [`--port=${port}`], {
    stdio: 'ignore',
    env: { PATH, LANG, HOME: home, DISPLAY: display.name, NO_AT_BRIDGE: '1' },
  });
  const stop = async () => {
    await ended(browser);
    display.stop();
    await rm(home, { recursive: true, force: true, maxRetries: 5 });
  };
  const send = async (method, address, body) => {
    const answer = await fetch(`http://127.0.0.1:${port}${address}`, { method, body: body && JSON.stringify(body) });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  try {
    await answers(() => send('GET', '/status'));
    const options = {
      'webkitgtk:browserOptions': { binary, args: ['--automation'] },
      timeouts: { script: 120_000, pageLoad: 120_000 },
    };
    const { sessionId } = await send('POST', '/session', { capabilities: { alwaysMatch: options } });
    const session = `/session/${sessionId}`;
    const page = new EnginePage(
      { width, height },
      {
        navigate: (url) => send('POST', `${session}/url`, { url }),
        reload: () => send('POST', `${session}/refresh`, {}),
        perform: (actions) => send('POST', `${session}/actions`, { actions }),
        capture: () => send('GET', `${session}/screenshot`),
        call: (text, argument) =>
          send('POST', `${session}/execute/sync`, { script: `return (${text})(arguments[0])`, args: [argument] }),
        async close() {
          await send('DELETE', session).catch(() => undefined);
          await stop();
        },
      },
    );
    await send('POST', `${session}/window/rect`, { width, height: height + BAR });
    return page;
  } catch (error) {
    await stop();
    throw error;
  }
}

/** The height of the browser's toolbar above the page, in pixels. */
const BAR = 38;

const freePort = () =>
  new Promise((resolve) => {
    const server = createServer();
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

async function answers(ask) {
  for (let attempt = 0; ; attempt++) {
    try {
      return await ask();
    } catch (error) {
      if (attempt === 100) throw error;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
}
