// A teacher wants to scan QR codes, and may not use the camera.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openHandIns, scanner } from '../scan.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { press, says } from '../words.mjs';

test('a camera that is not allowed is a sentence', () =>
  onPage({ ...TABLET, prepare: refuse }, async ({ page, troubles }) => {
    await openHandIns(page);
    await press(page, 'hand-ins-scan');
    await says(page, 'hand-ins-told', /camera may not be used/);
    assert.equal(await scanner(page).count(), 0);
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: as a user who says no. */
function refuse() {
  navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException('Permission denied', 'NotAllowedError'));
}
