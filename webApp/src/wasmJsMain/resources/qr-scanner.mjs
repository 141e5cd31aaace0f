// A dialog above the page with the camera's picture, in which QR codes are read. The page loads this module when it is first
// opened, in a script of its own: see docs/web-page.md.
import decodeQR from 'qr/decode.js';

const STYLE = `
  .robotran-scanner { box-sizing: border-box; width: min(640px, 100vw); max-width: 100vw; max-height: 100dvh; margin: auto;
    padding: 16px; border: 0; border-radius: 12px; background: #14202b; color: #fff; font: 16px/1.4 system-ui, sans-serif; }
  .robotran-scanner::backdrop { background: rgb(0 0 0 / 60%); }
  .robotran-scanner h2 { margin: 0 0 8px; font-size: 20px; }
  .robotran-scanner p { margin: 8px 0; min-height: 1.4em; }
  .robotran-scanner video { display: block; width: 100%; max-height: 60dvh; border-radius: 8px; background: #000;
    object-fit: contain; }
  .robotran-scanner button { min-width: 96px; min-height: 48px; padding: 0 24px; border: 0; border-radius: 24px;
    background: #ffd23f; color: #14202b; font: inherit; font-weight: 600; cursor: pointer; }
  .robotran-scanner button:focus-visible { outline: 3px solid #fff; outline-offset: 2px; }
`;

/** Milliseconds between two looks, so that the page stays alive. */
const PAUSE = 120;

/** A larger picture of a camera is made smaller: even the largest code has several pixels for each module then. */
const MOST_PIXELS = 1280;

const VIDEO = { facingMode: 'environment', width: { ideal: 1920 }, height: { ideal: 1080 } };

/**
 * Shows the camera until the user ends it, and calls `onFound` with each text once. What that returns is whether the text was
 * of use. Resolves to '' then, otherwise to the name of the error for which there is no picture, such as 'NotAllowedError'.
 *
 * `words` has the texts `title`, `hint`, `starting`, `counted` with '%1$d' for a number, `useless` and `done`. The app ends it
 * by `signal`, for example on the browser's Back.
 */
export async function scan(words, onFound, signal) {
  if (signal.aborted) return '';
  const view = openView(words);
  signal.addEventListener('abort', () => view.end());
  let stream = null;
  try {
    const coming = navigator.mediaDevices.getUserMedia({ audio: false, video: VIDEO });
    // A camera that comes after the dialog was closed is switched off again.
    coming.then((late) => view.isClosed() && switchOff(late)).catch(() => undefined);
    stream = await Promise.race([coming, view.closed]);
    if (!stream) return '';
    view.video.srcObject = stream;
    await Promise.race([view.video.play(), view.closed]);
    if (!view.isClosed()) await read(view, words, onFound, await reader());
    return '';
  } catch (error) {
    return view.isClosed() ? '' : error.name || String(error);
  } finally {
    if (stream) switchOff(stream);
    view.close();
  }
}

function openView(words) {
  const dialog = document.createElement('dialog');
  dialog.className = 'robotran-scanner';
  const part = (name, text) => {
    const element = document.createElement(name);
    element.textContent = text;
    dialog.append(element);
    return element;
  };
  part('h2', words.title).id = 'robotran-scanner-title';
  const hint = part('p', words.hint);
  const video = part('video', '');
  video.muted = true;
  video.playsInline = true;
  video.setAttribute('aria-hidden', 'true');
  const status = part('p', words.starting);
  status.setAttribute('role', 'status');
  const done = part('button', words.done);
  done.type = 'button';
  hint.id = 'robotran-scanner-hint';
  dialog.setAttribute('aria-labelledby', 'robotran-scanner-title');
  dialog.setAttribute('aria-describedby', hint.id);
  dialog.lang = document.documentElement.lang;
  const style = new CSSStyleSheet();
  style.replaceSync(STYLE);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, style];
  document.body.append(dialog);
  const closed = new Promise((resolve) => dialog.addEventListener('close', () => resolve(null)));
  done.addEventListener('click', () => dialog.close());
  // What happens here is none of the app's business.
  for (const type of ['keydown', 'keyup', 'copy', 'cut', 'paste']) dialog.addEventListener(type, (event) => event.stopPropagation());
  dialog.showModal();
  done.focus();
  return {
    video,
    closed,
    say: (text) => (status.textContent = text),
    isClosed: () => !dialog.open,
    end: () => dialog.close(),
    close() {
      if (dialog.open) dialog.close();
      dialog.remove();
      document.adoptedStyleSheets = document.adoptedStyleSheets.filter((each) => each !== style);
    },
  };
}

async function read(view, words, onFound, texts) {
  const seen = new Set();
  let useful = 0;
  view.say('');
  while (!view.isClosed()) {
    for (const text of await texts(view.video)) {
      if (seen.has(text) || view.isClosed()) continue;
      seen.add(text);
      if (onFound(text)) view.say(words.counted.replace('%1$d', String((useful += 1))));
      else view.say(words.useless);
    }
    await Promise.race([new Promise((resolve) => setTimeout(resolve, PAUSE)), view.closed]);
  }
}

/** A function that returns the texts in a picture: the browser's own detector where there is one, otherwise a library. */
async function reader() {
  const formats = await globalThis.BarcodeDetector?.getSupportedFormats().catch(() => []);
  if (formats?.includes('qr_code')) {
    const detector = new BarcodeDetector({ formats: ['qr_code'] });
    return async (video) => (await detector.detect(video).catch(() => [])).map(({ rawValue }) => rawValue);
  }
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d', { willReadFrequently: true });
  return async (video) => {
    const scale = Math.min(1, MOST_PIXELS / Math.max(video.videoWidth, video.videoHeight));
    canvas.width = Math.round(video.videoWidth * scale);
    canvas.height = Math.round(video.videoHeight * scale);
    if (canvas.width === 0 || canvas.height === 0) return [];
    context.drawImage(video, 0, 0, canvas.width, canvas.height);
    try {
      return [decodeQR(context.getImageData(0, 0, canvas.width, canvas.height))];
    } catch {
      return []; // There is none.
    }
  };
}

const switchOff = (stream) => stream.getTracks().forEach((track) => track.stop());
