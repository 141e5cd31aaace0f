// Loads the app and shows the progress. If the app cannot start, shows the reason instead of an empty page.
(() => {
  const WORDS = {
    en: {
      loading: 'Robotran is getting ready.',
      starting: 'Everything is here. Robotran starts.',
      oldBrowser: 'This browser is too old for Robotran. Please use a newer Chrome, Edge, Firefox or Safari.',
      noDrawing:
        'This browser cannot draw Robotran, because WebGL is switched off or missing in it. Please allow WebGL, or use another browser.',
      notFetched: 'A part of Robotran could not be fetched. Perhaps the network is away or blocks it.',
      noNetwork: 'The network is still away. Please try again a little later.',
      notStarted: 'Robotran could not start.',
      rest: 'One moment: the rest of Robotran is still on its way.',
      again: 'Try again',
      title: 'Welcome to Robotran',
      greeting: 'You write a program, and a robot draws it on a sheet of paper.',
      views: 'How do you want to build programs?',
      blocks: 'Blocks',
      text: 'Text',
      square: 'Run the square',
      tutorial: 'Start the lessons',
      worlds: 'Choose a world',
      chosen: 'Chosen. It begins as soon as everything is here.',
      details: 'Details',
    },
    es: {
      loading: 'Robotran se está preparando.',
      starting: 'Ya está todo aquí. Robotran empieza.',
      oldBrowser: 'Este navegador es demasiado antiguo para Robotran. Usa un Chrome, Edge, Firefox o Safari más nuevo.',
      noDrawing:
        'Este navegador no puede dibujar Robotran, porque WebGL está apagado o le falta. Permite WebGL o usa otro navegador.',
      notFetched: 'No se ha podido traer una parte de Robotran. Quizá no hay red, o la red no la deja pasar.',
      noNetwork: 'Sigue sin haber red. Inténtalo otra vez un poco más tarde.',
      notStarted: 'Robotran no ha podido empezar.',
      rest: 'Un momento: el resto de Robotran todavía está llegando.',
      again: 'Intentarlo otra vez',
      title: 'Te damos la bienvenida a Robotran',
      greeting: 'Tú escribes un programa y un robot lo dibuja en una hoja de papel.',
      views: '¿Cómo quieres construir programas?',
      blocks: 'Bloques',
      text: 'Texto',
      square: 'Ejecutar el cuadrado',
      tutorial: 'Empezar las lecciones',
      worlds: 'Elegir un mundo',
      chosen: 'Elegido. Empieza en cuanto esté todo aquí.',
      details: 'Detalles',
    },
    de: {
      loading: 'Robotran macht sich bereit.',
      starting: 'Alles ist da. Robotran fängt an.',
      oldBrowser: 'Dieser Browser ist zu alt für Robotran. Nimm bitte ein neueres Chrome, Edge, Firefox oder Safari.',
      noDrawing:
        'Dieser Browser kann Robotran nicht zeichnen, weil WebGL ausgeschaltet ist oder fehlt. Erlaube WebGL oder nimm einen anderen Browser.',
      notFetched:
        'Ein Teil von Robotran ließ sich nicht holen. Vielleicht ist das Netz weg oder lässt ihn nicht durch.',
      noNetwork: 'Das Netz ist noch weg. Versuche es bitte etwas später noch einmal.',
      notStarted: 'Robotran konnte nicht starten.',
      rest: 'Einen Moment: Der Rest von Robotran ist noch unterwegs.',
      again: 'Noch einmal versuchen',
      title: 'Willkommen bei Robotran',
      greeting: 'Du schreibst ein Programm, und ein Roboter zeichnet es auf ein Blatt Papier.',
      views: 'Wie willst du Programme bauen?',
      blocks: 'Blöcke',
      text: 'Text',
      square: 'Das Quadrat starten',
      tutorial: 'Mit den Lektionen beginnen',
      worlds: 'Eine Welt aussuchen',
      chosen: 'Ausgewählt. Es geht los, sobald alles da ist.',
      details: 'Einzelheiten',
    },
    fr: {
      loading: 'Robotran se prépare.',
      starting: 'Tout est là. Robotran démarre.',
      oldBrowser: 'Ce navigateur est trop ancien pour Robotran. Prends un Chrome, Edge, Firefox ou Safari plus récent.',
      noDrawing:
        'Ce navigateur ne peut pas dessiner Robotran, parce que WebGL y est désactivé ou absent. Active WebGL ou prends un autre navigateur.',
      notFetched: "Une partie de Robotran n'a pas pu être chargée. Le réseau est peut-être coupé, ou il la bloque.",
      noNetwork: "Il n'y a toujours pas de réseau. Réessaie un peu plus tard.",
      notStarted: "Robotran n'a pas pu démarrer.",
      rest: 'Un instant : le reste de Robotran est encore en route.',
      again: 'Réessayer',
      title: 'Bienvenue dans Robotran',
      greeting: 'Tu écris un programme, et un robot le dessine sur une feuille de papier.',
      views: 'Comment veux-tu construire tes programmes ?',
      blocks: 'Blocs',
      text: 'Texte',
      square: 'Lancer le carré',
      tutorial: 'Commencer les leçons',
      worlds: 'Choisir un monde',
      chosen: "C'est choisi. Ça commence dès que tout est là.",
      details: 'Détails',
    },
    pt: {
      loading: 'O Robotran está se preparando.',
      starting: 'Está tudo aqui. O Robotran vai começar.',
      oldBrowser: 'Este navegador é antigo demais para o Robotran. Use um Chrome, Edge, Firefox ou Safari mais novo.',
      noDrawing:
        'Este navegador não consegue desenhar o Robotran, porque o WebGL está desligado ou falta nele. Permita o WebGL ou use outro navegador.',
      notFetched: 'Não foi possível carregar uma parte do Robotran. Talvez não haja rede, ou a rede a bloqueie.',
      noNetwork: 'Ainda não há rede. Tente de novo um pouco mais tarde.',
      notStarted: 'O Robotran não conseguiu começar.',
      rest: 'Um momento: o resto do Robotran ainda está a caminho.',
      again: 'Tentar de novo',
      title: 'Boas-vindas ao Robotran',
      greeting: 'Você escreve um programa, e um robô o desenha em uma folha de papel.',
      views: 'Como você quer montar seus programas?',
      blocks: 'Blocos',
      text: 'Texto',
      square: 'Executar o quadrado',
      tutorial: 'Começar as lições',
      worlds: 'Escolher um mundo',
      chosen: 'Escolhido. Começa assim que tudo estiver aqui.',
      details: 'Detalhes',
    },
  };
  const ATTEMPTS = 3;
  const MOST_DETAILS = 4000;

  // Some browsers report invalid language tags such as `C`, which would stop Compose from starting.
  const isLanguage = (tag) => {
    try {
      return Boolean(new Intl.Locale(tag));
    } catch {
      return false;
    }
  };
  const languages = [...(navigator.languages || [navigator.language])];
  if (languages.length === 0 || ![...languages, navigator.language].every(isLanguage)) {
    const known = languages.filter(isLanguage);
    if (known.length === 0) known.push('en');
    // Not on `navigator` itself: the app overrides the property there for a chosen language and deletes it again.
    Object.defineProperty(Navigator.prototype, 'languages', { get: () => known, configurable: true });
    Object.defineProperty(Navigator.prototype, 'language', { get: () => known[0], configurable: true });
  }
  const asked = navigator.language.split('-')[0].toLowerCase();
  const tag = asked in WORDS ? asked : 'en';
  const words = WORDS[tag];
  const part = (name) => document.getElementById(name);

  // The files of this version of the app, written by the build: see docs/hosting.md.
  const site = JSON.parse(part('site').textContent);
  const base = new URL('.', location.href);
  const absolute = (address) => new URL(address, base).href;
  const fetchAsEver = globalThis.fetch;

  const say = (sentence) => {
    const place = part('loading-words');
    if (place) place.textContent = sentence;
  };

  /** The details for a bug report. */
  const report = (error) => {
    const [name, stack] = [String(error || ''), String((error && error.stack) || '')];
    return [
      stack.includes(name) ? stack : `${name}\n${stack}`,
      navigator.userAgent,
      `Robotran ${site.version}`,
      languages.join(),
    ]
      .map((line) => line.trim())
      .filter(Boolean)
      .join('\n')
      .slice(0, MOST_DETAILS);
  };

  /** With the greeting, the page has the composition of the app's welcome page, so nothing jumps when that appears. */
  const greet = (isGreeting) => {
    part('loading').classList.toggle('greets', isGreeting);
    for (const each of ['greeting-head', 'greeting']) part(each).hidden = !isGreeting;
  };

  let trouble = null;
  const fail = (reason, error) => {
    // An old browser or a failed download explains all later errors. A retry does not help in an old browser.
    if (!part('loading') || trouble === 'oldBrowser' || trouble === 'notFetched') return;
    trouble = reason;
    say(words[reason]);
    part('loading-progress').hidden = true;
    greet(false); // Nothing that it offers could be carried out.
    part('loading-again').hidden = reason === 'oldBrowser';
    part('loading-report').textContent = report(error);
    part('loading-details').hidden = false;
  };
  const canDraw = () => {
    try {
      const drawing = document.createElement('canvas').getContext('webgl2');
      // A browser allows only a few contexts.
      drawing?.getExtension('WEBGL_lose_context')?.loseContext();
      return drawing !== null;
    } catch {
      return false;
    }
  };
  const failToStart = (error) => fail(error && error.name === 'CompileError' ? 'oldBrowser' : 'notStarted', error);
  // What another script throws, such as an extension's, does not keep the app from being drawn.
  /** Whether the app threw something that nobody caught. */
  let hasThrown = false;
  const isOfApp = (error) =>
    (typeof WebAssembly === 'object' && WebAssembly.Exception && error instanceof WebAssembly.Exception) ||
    /wasm/.test(String((error && error.stack) || ''));
  const onError = (event) => {
    if (event.target instanceof HTMLScriptElement) return fail('notFetched', event.target.src);
    if (isOfApp(event.error)) hasThrown = true;
    return failToStart(event.error || event.message);
  };
  const onRejection = (event) => failToStart(event.reason);
  addEventListener('error', onError, true);
  addEventListener('unhandledrejection', onRejection);

  document.documentElement.lang = tag;
  say(words.loading);
  part('loading-again').textContent = words.again;
  part('loading-details').firstElementChild.textContent = words.details;
  part('loading-again').addEventListener('click', async () => {
    const answer = await fetchAsEver(base, { cache: 'reload' }).catch(() => null);
    if (answer && answer.ok) location.reload();
    else say(words.noNetwork);
  });

  // The first visit is greeted with the choices of the app's welcome page. A choice is carried out when the app is there.
  const VISITED = 'robotran visited';
  const visited = () => {
    try {
      return localStorage.getItem(VISITED) !== null;
    } catch {
      return true; // Storage is switched off.
    }
  };
  const isFirstVisit = !visited();
  const isEmbedded = new URLSearchParams(location.search).has('embed') || window.top !== window;
  const choices = [...document.querySelectorAll('[data-wish]')];
  let wish = '';
  const needsRest = (chosen) => chosen !== '' && chosen !== 'square';
  for (const choice of choices) {
    choice.textContent = words[choice.dataset.wish];
    choice.addEventListener('click', () => {
      wish = choice.dataset.wish;
      for (const each of choices) each.setAttribute('aria-pressed', String(each === choice));
      if (!trouble) say(words.chosen);
    });
  }
  // As the app begins if nothing is chosen: in blocks where the main pointer is a finger, see `Platform.isForFingers`.
  const firstView = matchMedia('(pointer: coarse)').matches ? 'blocks' : 'text';
  let view = '';
  for (const each of document.querySelectorAll('[name="view"]')) {
    each.nextElementSibling.textContent = words[each.value];
    each.checked = each.value === firstView;
    each.addEventListener('change', () => {
      view = each.value;
    });
  }
  part('greeting-views').textContent = words.views;
  if (!isFirstVisit) part('loading-progress').removeAttribute('value');
  part('greeting-title').textContent = words.title;
  part('greeting-words').textContent = words.greeting;

  // Who comes for the first time begins with the first parts. Links, embedded pages and saved work need more, and whoever
  // comes again has everything at hand.
  const isGreeted = !isEmbedded && location.hash.length <= 1 && isFirstVisit;
  greet(isGreeted);
  const needed = isGreeted ? site.first : [...site.first, ...site.rests.flat()];
  const count = needed.reduce((sum, [, bytes]) => sum + bytes, 0);
  let here = 0;
  const arrived = (bytes) => {
    here += bytes;
    const bar = part('loading-progress');
    if (bar) bar.value = Math.min(1, here / count);
    if (here === count && !trouble && !wish) say(words.starting);
  };

  const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  // A captive portal responds with its own HTML page.
  const isWanted = (response) => response.ok && !(response.headers.get('content-type') || '').startsWith('text/html');
  const download = async (address, isNeeded = true) => {
    for (let attempt = 1; attempt <= ATTEMPTS; attempt++) {
      const response = await fetchAsEver(address).catch(() => null);
      if (response && isWanted(response)) return response;
      if (attempt < ATTEMPTS) await pause(attempt * 700);
    }
    const error = new Error(`${address} could not be fetched`);
    if (isNeeded) fail('notFetched', error);
    throw error;
  };
  const countBytes = async (response) => {
    const reader = response.body.getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      arrived(value.length);
    }
  };
  // Browsers compile wasm from a stream only if the server sends its MIME type.
  const typed = (address, response) =>
    !address.endsWith('.wasm') || (response.headers.get('content-type') || '').startsWith('application/wasm')
      ? response
      : new Response(response.body, { headers: { 'content-type': 'application/wasm' } });

  // Everything that the first frame needs is downloaded in parallel and passed to the app on request.
  const coming = new Map();
  const bring = async ([address]) => {
    const answer = await download(absolute(address));
    // Browsers keep compiled code only for a response that is read once. Later visits show no progress anyway.
    if (isFirstVisit) countBytes(answer.clone()).catch((error) => fail('notFetched', error));
    const response = typed(address, answer);
    if (site.streamed.includes(address)) compileWhileItComes(address, response);
    return response;
  };
  const parts = globalThis.robotranParts({ rests: site.rests, words, absolute, download: (address) => downloadWhenFree(address) });

  // The app would compile one module after the other, each when the one before runs. With Kotlin's options for both.
  const compiled = new WeakMap();
  const compilations = new Map();
  const numbers = new WeakMap();
  const compileWhileItComes = (address, response) => {
    const module = WebAssembly.compileStreaming(response, parts.BUILTINS);
    module.catch(() => undefined); // The app reports it.
    compilations.set(address, module);
    compiled.set(response, module);
    numbers.set(response, site.streamed.indexOf(address));
  };

  // What comes later leaves the network to what is needed first.
  const downloadWhenFree = async (address) => {
    await Promise.allSettled(compilations.values());
    return typed(address, await download(address, false));
  };
  const instantiateStreaming = WebAssembly.instantiateStreaming.bind(WebAssembly);
  const instantiateWhatIsCompiled = async (source, imports, options) => {
    const response = await source;
    if (!compiled.has(response)) return instantiateStreaming(response, imports, options);
    const module = await compiled.get(response);
    const instance = await WebAssembly.instantiate(module, imports);
    const number = numbers.get(response);
    parts.connect(number, instance, imports);
    if (!isGreeted) await parts.complete(number);
    else if (needsRest(wish)) await parts.complete(number).catch(() => undefined);
    return { module, instance };
  };
  // Compose downloads the font of programs again for each screen with one.
  const repeated = new Map();
  const bytesOf = (address, answer = download(address)) => {
    const bytes = answer.then((response) => response.arrayBuffer());
    repeated.set(address, bytes);
    bytes.catch(() => repeated.delete(address));
    return bytes;
  };
  const fetchWhatComes = (input, options) => {
    const address = typeof input === 'string' || input instanceof URL ? absolute(input) : '';
    const known = repeated.get(address);
    if (known) return known.then((bytes) => new Response(bytes));
    const response = coming.get(address);
    if (!response) return fetchAsEver(input, options);
    coming.delete(address);
    return response;
  };

  // While this page is open, the service worker keeps the files of its version; see service-worker.js.
  const version = `robotran ${base.pathname} ${site.version}`;
  if (navigator.locks)
    navigator.locks.request(version, { mode: 'shared' }, () => new Promise(() => undefined)).catch(() => undefined);

  const keepForLater = async () => {
    // An embedded page is not cached.
    if (!navigator.serviceWorker || window.top !== window) return;
    await navigator.serviceWorker.register(absolute('service-worker.js'), { updateViaCache: 'none' });
    const { active } = await navigator.serviceWorker.ready;
    active.postMessage('tidy up');
  };
  const whenIdle = (action) =>
    'requestIdleCallback' in globalThis ? requestIdleCallback(action, { timeout: 5000 }) : setTimeout(action, 1000);

  const fadeOut = (loading) => {
    if (!loading) return;
    loading.removeAttribute('id'); // It no longer takes part in anything.
    loading.classList.add('leaving'); // Its layout stays until it is gone.
    loading.inert = true;
    const leave = () => loading.remove();
    loading.addEventListener('animationend', (event) => event.target === loading && leave());
    setTimeout(leave, 500); // If the browser does not animate.
  };

  globalThis.robotranPage = {
    /** The URL of one of the app's resources, whose file name contains a content hash. */
    addressOf: (path) => absolute(site.resources[path] || path),

    /** The test tags of what works before all parts have come. */
    atOnce: parts.AT_ONCE,

    /** What was chosen on the greeting, as soon as it can be done: `square`, `tutorial` or `worlds`; empty if nothing. */
    async wish() {
      if (needsRest(wish)) await parts.allCome;
      return wish;
    },

    /** How programs are shown as chosen on the greeting: `blocks` or `text`; empty if nothing was chosen. */
    view: () => view,

    /** A worker with another instance of the app, see `worker.js`. */
    openWorker() {
      const worker = new Worker(absolute(site.worker));
      const [app, skiko] = site.streamed;
      const scripts = [...site.chunks, site.script].map(absolute);
      const order = { scripts, app: absolute(app), skiko: absolute(skiko) };
      const modules = [compilations.get(app), parts.restOf(0)];
      // If a part does not come, the worker does not answer, which the app expects of one that has died.
      Promise.all(modules).then(([module, rest]) => worker.postMessage({ ...order, module, rest }), () => undefined);
      return worker;
    },

    /** Called when the app is visible. Removes the loading screen and, once idle, caches everything for offline use. */
    started() {
      for (const choice of choices) choice.disabled = true;
      parts.hold();
      const rest = parts.bring().catch(() => undefined);
      const isDone = () => {
        removeEventListener('error', onError, true);
        removeEventListener('unhandledrejection', onRejection);
      };
      if (document.hidden) isDone(); // Nothing is drawn that could fail.
      // Wait until it is drawn. What goes wrong meanwhile is told, since nothing else would be seen.
      requestAnimationFrame(() =>
        requestAnimationFrame(() => {
          if (!hasThrown) fadeOut(part('loading'));
          isDone();
        }),
      );
      try {
        localStorage.setItem(VISITED, 'yes');
      } catch {
        // Without storage every visit is greeted like a later one.
      }
      coming.clear();
      whenIdle(() => rest.then(keepForLater).catch(() => undefined));
    },
  };

  // A module with only a struct type. It is valid only in browsers with Wasm GC.
  const structType = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 95, 1, 127, 0]);
  if (typeof WebAssembly !== 'object' || !WebAssembly.validate(structType)) {
    fail('oldBrowser');
    return;
  }
  if (!canDraw()) {
    fail('noDrawing');
    return;
  }
  globalThis.fetch = fetchWhatComes;
  WebAssembly.instantiateStreaming = instantiateWhatIsCompiled;
  for (const file of needed) {
    const response = bring(file);
    response.catch(() => undefined);
    const address = absolute(file[0]);
    const number = site.rests.findIndex((pieces) => pieces.includes(file));
    if (number >= 0) parts.expect(number, site.rests[number].indexOf(file), response);
    else if (address.endsWith('.ttf')) bytesOf(address, response);
    else coming.set(address, response);
  }
  const script = document.createElement('script');
  script.src = site.script;
  document.head.append(script);
})();
