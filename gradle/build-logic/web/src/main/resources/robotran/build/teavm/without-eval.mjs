/* Replaces the uses of `new Function` in TeaVM's loader, so that a content security policy may forbid `eval`. */

function globalNamed(name) {
  if (!(name in globalThis)) throw new ReferenceError(`${name} is not defined`);
  return globalThis[name];
}

/**
 * Passes its arguments to FN. If VARARG, the arguments from index COUNT on become one array. Java exceptions become
 * JavaScript errors.
 */
function handingOn(fn, count, vararg, rethrow) {
  return function (...values) {
    try {
      return vararg ? fn(...values.slice(0, count - 1), values.slice(count - 1)) : fn(...values);
    } catch (e) {
      rethrow(e);
    }
  };
}

/** The same for a method; `this` becomes the first argument. */
function handingOnWithThis(fn, count, vararg, rethrow) {
  return function (...values) {
    try {
      return vararg ? fn(this, ...values.slice(0, count - 1), values.slice(count - 1)) : fn(this, ...values);
    } catch (e) {
      rethrow(e);
    }
  };
}

/** Wraps CONSTRUCTOR in a function called NAME. */
function renamed(name, constructor) {
  return {
    [name]: function (marker, javaObject) {
      return constructor.call(this, marker, javaObject);
    },
  }[name];
}

/** The scripts used from Java's class library, by their parameters and code. */
const SCRIPTS = {
  '(str) return str;': (str) => str,
  '(number) return number;': (number) => number,
  '() return navigator.hardwareConcurrency;': () => navigator.hardwareConcurrency,
};

/** The last of TEXTS is the body, the others are the parameter names. All are requested when the module is loaded. */
function scriptOf(...texts) {
  const body = texts.pop();
  const key = `(${texts.join(', ')}) ${body}`;
  if (!Object.hasOwn(SCRIPTS, key)) throw new Error(`without-eval.mjs has to know the script ${key}`);
  return SCRIPTS[key];
}
