// What has come into a simulated robot.

export const brick = (page) =>
  page.evaluate(() => {
    const { firmware, program, firmwareBytes, blocks, device } = globalThis.brick;
    return { firmware, program, firmwareBytes, blocks, asked: device.asked };
  });

export const isImage = (bytes) => bytes !== null && bytes[0] === 0xca && bytes[1] === 0xf6 && bytes.length > 300;

/** Waits until the sheet that sends says `pattern`. */
export const ends = (page, pattern) =>
  page.waitForFunction(
    (source) => new RegExp(source).test(document.querySelector('#robotran-words [data-tag="send-step"]')?.textContent),
    pattern.source,
  );

export const IN_ROBOT = /in the robot\. Press Run/;
