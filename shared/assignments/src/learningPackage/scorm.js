// Shows an assignment in a frame, and tells a learning platform what the page in it reports: SCORM 1.2 or SCORM 2004,
// whichever the platform offers. docs/assignments.md describes the messages.
(() => {
  const HIGHEST_SCORE = 100;
  // What the standards allow in suspend data, in characters.
  const LIMIT_1_2 = 4096;
  const LIMIT_2004 = 64000;
  // The standards allow the platform's object this many windows above.
  const MOST_WINDOWS = 500;

  /** The object `name` of the platform in one of the windows around `from`; null if there is none. */
  const foundAround = (from, name) => {
    let place = from;
    for (let count = 0; place && count < MOST_WINDOWS; count++) {
      try {
        if (place[name]) return place[name];
      } catch {
        return null; // a window of another site
      }
      if (place.parent === place) return null;
      place = place.parent;
    }
    return null;
  };
  const found = (name) => foundAround(window, name) ?? (window.opener ? foundAround(window.opener, name) : null);

  const hours = (seconds) => {
    const two = (number) => String(Math.floor(number)).padStart(2, '0');
    return `${two(seconds / 3600).padStart(4, '0')}:${two((seconds / 60) % 60)}:${two(seconds % 60)}.00`;
  };

  const scorm2004 = (api) => ({
    limit: LIMIT_2004,
    begin: () => api.Initialize(''),
    work: () => api.GetValue('cmi.suspend_data'),
    keep: (work) => api.SetValue('cmi.suspend_data', work),
    tell: ({ score, completed }) => {
      api.SetValue('cmi.score.min', '0');
      api.SetValue('cmi.score.max', String(HIGHEST_SCORE));
      api.SetValue('cmi.score.raw', String(Math.round(score * HIGHEST_SCORE)));
      api.SetValue('cmi.score.scaled', score.toFixed(2));
      api.SetValue('cmi.progress_measure', score.toFixed(2));
      api.SetValue('cmi.completion_status', completed ? 'completed' : 'incomplete');
      api.SetValue('cmi.success_status', completed ? 'passed' : 'unknown');
    },
    save: () => api.Commit(''),
    end: (seconds) => {
      api.SetValue('cmi.session_time', `PT${Math.round(seconds)}S`);
      api.SetValue('cmi.exit', 'suspend');
      api.Terminate('');
    },
  });

  const scorm12 = (api) => ({
    limit: LIMIT_1_2,
    begin: () => api.LMSInitialize(''),
    work: () => api.LMSGetValue('cmi.suspend_data'),
    keep: (work) => api.LMSSetValue('cmi.suspend_data', work),
    tell: ({ score, completed }) => {
      api.LMSSetValue('cmi.core.score.min', '0');
      api.LMSSetValue('cmi.core.score.max', String(HIGHEST_SCORE));
      api.LMSSetValue('cmi.core.score.raw', String(Math.round(score * HIGHEST_SCORE)));
      api.LMSSetValue('cmi.core.lesson_status', completed ? 'passed' : 'incomplete');
    },
    save: () => api.LMSCommit(''),
    end: (seconds) => {
      api.LMSSetValue('cmi.core.session_time', hours(seconds));
      api.LMSSetValue('cmi.core.exit', 'suspend');
      api.LMSFinish('');
    },
  });

  const [newer, older] = [found('API_1484_11'), found('API')];
  const platform = newer ? scorm2004(newer) : older ? scorm12(older) : null;
  platform?.begin();

  const frame = document.getElementById('robotran');
  const begun = Date.now();
  let best = -1;
  let isOver = false;

  const answers = {
    ready: () => {
      const work = platform?.work();
      if (work) frame.contentWindow.postMessage({ robotran: 1, kind: 'resume', work }, location.origin);
    },
    result: ({ score, completed }) => {
      if (!platform || score <= best) return;
      best = score;
      platform.tell({ score, completed });
      platform.save();
    },
    work: ({ work }) => {
      if (!platform || typeof work !== 'string' || work.length > platform.limit) return;
      platform.keep(work);
      platform.save();
    },
  };
  addEventListener('message', ({ source, origin, data }) => {
    if (isOver || source !== frame.contentWindow || origin !== location.origin || data?.robotran !== 1) return;
    answers[data.kind]?.(data);
  });
  addEventListener('pagehide', () => {
    if (isOver) return;
    isOver = true;
    platform?.end((Date.now() - begun) / 1000);
  });

  const number = Number(new URLSearchParams(location.search).get('assignment') ?? 0);
  frame.src = `site/index.html?embed=assignment${globalThis.robotranAssignments[number]}`;
})();
