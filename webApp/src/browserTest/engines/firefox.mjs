// Firefox, driven by its WebDriver BiDi server (W3C, over a WebSocket).
import { spawn } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { startDisplay } from './display.mjs';
import { EnginePage } from './engine-page.mjs';
import { ended } from './ended.mjs';

/** Enables WebGL on unknown graphics cards, and disables prompts and background downloads. */
const PREFERENCES = {
  'webgl.force-enabled': true,
  'app.update.auto': false,
  'browser.shell.checkDefaultBrowser': false,
  'browser.startup.page': 0,
  'datareporting.policy.dataSubmissionEnabled': false,
  'network.captive-portal-service.enabled': false,
  'network.connectivity-service.enabled': false,
  'toolkit.telemetry.enabled': false,
};

/** A page is waited for until it has been read: Firefox calls none complete whose script still waits for an answer. */
const READ = 'interactive';

/** Opens an empty page of this size in a new Firefox. */
export async function openFirefox(executable, { width, height }) {
  const home = await mkdtemp(path.join(os.tmpdir(), 'robotran-firefox-'));
  const lines = Object.entries(PREFERENCES).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${value});`);
  await writeFile(path.join(home, 'user.js'), lines.join('\n'));
  const display = await startDisplay();
  const browser = spawn(executable, ['--no-remote', '--remote-debugging-port', '0', '--profile', home, 'about:blank'], {
    stdio: ['ignore', 'ignore', 'pipe'],
    env: { ...process.env, HOME: home, DISPLAY: display.name, MOZ_CRASHREPORTER_DISABLE: '1' },
  });
  const stop = async () => {
    await ended(browser);
    display.stop();
    await rm(home, { recursive: true, force: true, maxRetries: 5 });
  };
  try {
    const send = await connect(`${await addressOf(browser)}/session`);
    await send('session.new', { capabilities: {} });
    const { context } = await send('browsingContext.create', { type: 'tab' });
    await send('browsingContext.setViewport', { context, viewport: { width, height } });
    return new EnginePage(
      { width, height },
      {
        navigate: (url) => send('browsingContext.navigate', { context, url, wait: READ }),
        reload: () => send('browsingContext.reload', { context, wait: READ }),
        perform: (actions) => send('input.performActions', { context, actions }),
        capture: async () => (await send('browsingContext.captureScreenshot', { context })).data,
        async call(functionDeclaration, argument) {
          const answer = await send('script.callFunction', {
            functionDeclaration,
            arguments: [{ type: 'string', value: argument }],
            target: { context },
            awaitPromise: true,
          });
          if (answer.type === 'exception') throw new Error(answer.exceptionDetails.text);
          return answer.result.value;
        },
        close: stop,
      },
    );
  } catch (error) {
    await stop();
    throw error;
  }
}

/** The address it listens on, which it prints to standard error. */
const addressOf = (browser) =>
  new Promise((resolve, reject) => {
    let said = '';
    browser.stderr.on('data', (part) => {
      said += part;
      const address = /WebDriver BiDi listening on (ws:\S+)/.exec(said);
      if (address) resolve(address[1]);
    });
    browser.once('error', reject);
    browser.once('exit', () => reject(new Error(`Firefox does not start: ${said}`)));
  });

/** Returns a function that sends a command and returns its result. */
async function connect(address) {
  const socket = new WebSocket(address);
  const waiting = new Map();
  let last = 0;
  socket.addEventListener('message', ({ data }) => {
    const { id, type, result, error, message } = JSON.parse(data);
    const asked = waiting.get(id);
    waiting.delete(id);
    if (type === 'error') asked?.reject(new Error(`${error}: ${message}`));
    else asked?.resolve(result);
  });
  socket.addEventListener('close', () => waiting.forEach(({ reject }) => reject(new Error('Firefox is gone'))));
  await new Promise((resolve, reject) => {
    socket.addEventListener('open', resolve);
    socket.addEventListener('error', () => reject(new Error(`${address} does not answer`)));
  });
  return (method, params) =>
    new Promise((resolve, reject) => {
      waiting.set(++last, { resolve, reject });
      socket.send(JSON.stringify({ id: last, method, params }));
    });
}
