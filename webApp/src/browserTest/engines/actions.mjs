// Keys and clicks as actions of both W3C WebDriver and WebDriver BiDi.
const NAMED = {
  Backspace: '\uE003',
  Tab: '\uE004',
  Enter: '\uE006',
  Shift: '\uE008',
  Control: '\uE009',
  Escape: '\uE00C',
  Home: '\uE011',
  End: '\uE010',
  Delete: '\uE017',
};
const keyOf = (name) => NAMED[name] ?? name;

/** A key, or several keys held together, such as `Control+a`. */
export function pressed(keys) {
  const held = keys.split('+').map(keyOf);
  return keyboard([
    ...held.map((value) => ({ type: 'keyDown', value })),
    ...held.toReversed().map((value) => ({ type: 'keyUp', value })),
  ]);
}

/** Types all characters of a text in order. */
export const typed = (text) =>
  keyboard(
    [...text].flatMap((value) => [
      { type: 'keyDown', value },
      { type: 'keyUp', value },
    ]),
  );

/** A click of the primary mouse button, as long as a human click. */
export const clicked = (x, y) => [
  {
    type: 'pointer',
    id: 'mouse',
    parameters: { pointerType: 'mouse' },
    actions: [
      { type: 'pointerMove', x: Math.round(x), y: Math.round(y) },
      { type: 'pointerDown', button: 0 },
      { type: 'pause', duration: 60 },
      { type: 'pointerUp', button: 0 },
    ],
  },
];

const keyboard = (actions) => [{ type: 'key', id: 'keyboard', actions }];
