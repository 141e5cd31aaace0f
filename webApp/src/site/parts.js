// The modules of the app come in two parts: the functions that the first minute calls, and the rest, in pieces, see
// docs/hosting.md. The rest is requested when the first parts are compiled. What is touched before it is there is held back
// and done then.
globalThis.robotranParts = ({ rests, words, download, absolute }) => {
  // Kotlin's options.
  const BUILTINS = { builtins: ['js-string'], importedStringConstants: "'" };

  // A table that the first part exports. Its entry 0 is a function that the first part calls when an entry is missing.
  const ENTRIES_OF_REST = 'first.cold';
  // A module that exports its import `page.call` as `call`: a table takes no function of JavaScript.
  const CALL = 'AGFzbQEAAAABBAFgAAACDQEEcGFnZQRjYWxsAAAHCAEEY2FsbAAA';
  const bytesIn = (text) => Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const callable = (call) => new WebAssembly.Instance(new WebAssembly.Module(bytesIn(atob(CALL))), { page: { call } }).exports.call;

  /** By what name the pieces behind it import from a piece: see `RestPieces.kt`. */
  const nameOfPiece = (number) => (number === 0 ? 'rest' : `rest-${number + 1}`);

  /** What can be touched although the rest is missing: the journeys that recorded the first part touch the same. */
  const AT_ONCE = ['try-square'];

  const parts = rests.map((pieces) => ({
    pieces: pieces.map(([address]) => ({ address: absolute(address), module: null })), // A promise of each module.
    imports: null, // What they are instantiated with.
    joining: null, // A promise, from the request on until it fails.
    isHere: false,
  }));
  let haveCome;
  const allCome = new Promise((resolve) => {
    haveCome = resolve;
  });

  /** Requests a piece, if that was not done or has failed. */
  const moduleOf = (piece, response = download(piece.address)) => {
    if (piece.module === null) {
      piece.module = WebAssembly.compileStreaming(response, BUILTINS);
      piece.module.catch(() => {
        piece.module = null;
      });
    }
    return piece.module;
  };
  const modulesOf = (part) => Promise.all(part.pieces.map((piece) => moduleOf(piece)));

  /** Connects the modules of a part, all at once: nothing can call a piece whose next one is missing. */
  const arrive = (part, modules) => {
    let imports = part.imports;
    modules.forEach((module, number) => {
      const { exports } = new WebAssembly.Instance(module, imports);
      imports = { ...imports, [nameOfPiece(number)]: exports };
    });
    part.isHere = true;
    if (parts.every(({ isHere }) => isHere)) haveCome();
  };

  const instantiate = async (part) => {
    const modules = await modulesOf(part);
    if (!part.isHere) arrive(part, modules); // There must be one instance of each alone.
  };

  /** Requests a part and connects it, once. */
  const join = (part) => {
    part.joining ??= instantiate(part).catch((error) => {
      part.joining = null;
      throw error;
    });
    return part.joining;
  };

  const moduleAtOnce = ({ address }) => {
    const request = new XMLHttpRequest();
    request.open('GET', address, false);
    // Only text can be waited for: each byte is a letter.
    request.overrideMimeType('text/plain; charset=x-user-defined');
    request.send();
    if (request.status !== 200) throw new Error(`${address} could not be fetched`);
    return new WebAssembly.Module(bytesIn(request.responseText), BUILTINS);
  };

  /**
   * A call of a function that is not there, such as by a timer. WebAssembly cannot wait for anything but these requests,
   * and the page stands still meanwhile.
   */
  const joinAtOnce = (part) => {
    try {
      arrive(part, part.pieces.map(moduleAtOnce));
    } catch (error) {
      isBroken = true; // The app has been left in the middle of something.
      tell(words.notFetched);
      throw error;
    }
  };

  let isBroken = false;
  let told = null;

  /** Says something at the top of the page, with a button to try again if something is missing. */
  const tell = (sentence) => {
    told ??= document.body.appendChild(document.createElement('aside'));
    told.id = 'parts';
    told.setAttribute('role', 'status');
    const paragraph = document.createElement('p');
    paragraph.textContent = sentence;
    const again = document.createElement('button');
    again.type = 'button';
    again.textContent = words.again;
    again.addEventListener('click', () => {
      if (isBroken) {
        location.reload();
      } else {
        tell(words.rest);
        bring().catch(() => undefined);
      }
    });
    told.replaceChildren(...(sentence === words.rest ? [paragraph] : [paragraph, again]));
  };
  const beQuiet = () => {
    told?.remove();
    told = null;
  };

  /** Requests what is missing and joins it. */
  const bring = async () => {
    try {
      await Promise.all(parts.map(join));
    } catch (error) {
      if (isHolding) tell(words.notFetched);
      throw error;
    }
  };

  const EVENTS = ['pointerdown', 'pointermove', 'pointerup', 'pointercancel', 'pointerenter', 'pointerleave', 'wheel', 'keydown', 'keyup', 'click'];
  const KEPT = ['pointerdown', 'pointerup', 'keydown', 'keyup', 'click'];
  const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  let isHolding = false;
  let isPassing = false;
  let held = [];

  const isAtOnce = ({ target, clientX, clientY, type }) =>
    AT_ONCE.some((tag) => {
      const element = document.querySelector(`#robotran-words [data-tag="${tag}"]`);
      if (!element || type === 'click') return element !== null && element === target;
      const { left, right, top, bottom } = element.getBoundingClientRect();
      return clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;
    });

  const take = (event) => {
    // The page's own loading screen and words need no part.
    if (!event.isTrusted || (event.target instanceof Element && event.target.closest('#parts, #loading, .leaving'))) return;
    // The canvas answers pointers, and the elements for screen readers answer clicks.
    if (event.type === 'click' && event.target instanceof HTMLCanvasElement) return;
    if (event.type === 'pointerdown') isPassing = isAtOnce(event);
    if (event.type === 'click' ? isAtOnce(event) : isPassing && event.type.startsWith('pointer')) {
      if (['pointerup', 'pointercancel'].includes(event.type)) isPassing = false;
      return;
    }
    event.stopImmediatePropagation();
    if (event.cancelable) event.preventDefault();
    if (!KEPT.includes(event.type) || (event.type === 'pointerup' && held.length === 0)) return;
    if (event.type === 'pointerdown') held = []; // Whoever touches again means that.
    held.push([event, event.target]);
    if (told === null) tell(words.rest);
  };

  const hold = () => {
    if (parts.every(({ isHere }) => isHere)) return;
    isHolding = true;
    allCome.then(letGo);
    for (const type of EVENTS) addEventListener(type, take, { capture: true, passive: false });
  };

  /** Repeats what was held back. */
  const letGo = async () => {
    isHolding = false;
    beQuiet();
    while (held.length > 0) {
      const [event, target] = held.shift();
      const place = target.isConnected ? target : document.elementFromPoint(event.clientX, event.clientY);
      place?.dispatchEvent(new event.constructor(event.type, event));
      if (event.type !== 'pointerup') await nextFrame(); // Between a finger that goes down and up.
    }
    for (const type of EVENTS) removeEventListener(type, take, { capture: true });
  };

  return {
    BUILTINS,
    AT_ONCE,
    bring,
    hold,

    /** Resolved when all parts have been joined. */
    allCome,

    /** Uses the `response` to a request of a piece of the rest of the module `number` that was made already. */
    expect: (number, piece, response) => moduleOf(parts[number].pieces[piece], response).catch(() => undefined),

    /** The compiled pieces of the rest of the module `number`, each with the name by which those behind it import from it. */
    restOf: async (number) =>
      (parts[number] ? await modulesOf(parts[number]) : []).map((module, piece) => [nameOfPiece(piece), module]),

    /** Connects the first part of the module `number`, an instance made with `imports`, with its rest. */
    connect(number, instance, imports) {
      if (number >= parts.length) return;
      parts[number].imports = { ...imports, first: instance.exports };
      instance.exports[ENTRIES_OF_REST].set(0, callable(() => joinAtOnce(parts[number])));
    },

    /** Joins the rest of the module `number` before the app uses it. */
    complete: async (number) => parts[number] && join(parts[number]),
  };
};
