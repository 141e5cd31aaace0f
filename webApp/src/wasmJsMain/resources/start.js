// Says honestly what is the matter where the app cannot start, instead of leaving an empty page.
(() => {
  const WORDS = {
    en: {
      loading: 'Robotran is getting ready.',
      oldBrowser: 'This browser is too old for Robotran. Please use a newer Chrome, Edge, Firefox or Safari.',
      notStarted: 'Robotran could not start. Please reload the page.',
    },
    es: {
      loading: 'Robotran se está preparando.',
      oldBrowser: 'Este navegador es demasiado antiguo para Robotran. Usa un Chrome, Edge, Firefox o Safari más nuevo.',
      notStarted: 'Robotran no ha podido empezar. Vuelve a cargar la página.',
    },
    de: {
      loading: 'Robotran macht sich bereit.',
      oldBrowser: 'Dieser Browser ist zu alt für Robotran. Nimm bitte ein neueres Chrome, Edge, Firefox oder Safari.',
      notStarted: 'Robotran konnte nicht starten. Lade die Seite bitte neu.',
    },
  };
  const asked = (navigator.language || 'en').split('-')[0].toLowerCase();
  const tag = asked in WORDS ? asked : 'en';
  const words = WORDS[tag];
  const say = (sentence) => {
    const place = document.getElementById('loading');
    if (place) place.textContent = sentence;
  };

  // A struct type and nothing else: only a browser with Wasm GC takes it for valid.
  const structType = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 95, 1, 127, 0]);
  const hasWasmGc = typeof WebAssembly === 'object' && WebAssembly.validate(structType);

  let failed = !hasWasmGc;
  const fail = () => {
    failed = true;
    say(hasWasmGc ? words.notStarted : words.oldBrowser);
  };

  addEventListener('DOMContentLoaded', () => {
    document.documentElement.lang = tag;
    if (failed) fail(); else say(words.loading);
  });
  addEventListener('error', fail, true);
  addEventListener('unhandledrejection', fail);
})();
