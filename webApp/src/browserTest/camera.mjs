// What Chromium takes for the picture of a camera.
import { writeFile } from 'node:fs/promises';

const WIDTH = 640;
const HEIGHT = 480;
const FRAMES = 30;

/** The brightness of the pixels of `picture`, a PNG, in the middle of a grey picture of the camera's size. */
async function brightness(page, picture) {
  const encoded = await page.evaluate(
    async ([base64, width, height]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.fillStyle = '#999';
      context.fillRect(0, 0, width, height);
      const side = Math.min(image.width, height - 20);
      context.drawImage(image, (width - side) / 2, (height - side) / 2, side, side);
      const { data } = context.getImageData(0, 0, width, height);
      let text = '';
      for (let place = 0; place < data.length; place += 4) text += String.fromCharCode(data[place + 1]);
      return btoa(text);
    },
    [picture.toString('base64'), WIDTH, HEIGHT],
  );
  return Buffer.from(encoded, 'base64');
}

/** Writes a film (YUV4MPEG2) of `pictures`, PNGs that are shown for three seconds each; `page` reads them. */
export async function film(page, pictures, file) {
  const parts = [`YUV4MPEG2 W${WIDTH} H${HEIGHT} F10:1 Ip A1:1 C420mpeg2\n`];
  const colours = Buffer.alloc((WIDTH * HEIGHT) / 2, 128);
  for (const picture of pictures) {
    const grey = await brightness(page, picture);
    for (let frame = 0; frame < FRAMES; frame++) parts.push('FRAME\n', grey, colours);
  }
  await writeFile(file, Buffer.concat(parts.map((part) => Buffer.from(part))));
}

/** For Chromium: its camera shows `file`, again and again. */
export const cameraOf = (file) => [
  '--use-fake-device-for-media-stream',
  `--use-file-for-fake-video-capture=${file}`,
];
