/* What TeaVM's loader makes of texts by `new Function`, made without: a page's security policy need not allow texts to become code. */

function globalNamed(name) {
  if (!(name in globalThis)) throw new ReferenceError(`${name} is not defined`);
  return globalThis[name];
}

/**
 * Hands its arguments on to FN, those from number COUNT on as one array if it wants them so; what goes wrong in Java
 * goes wrong in JavaScript.
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

/** The same for a method, whose object goes first. */
function handingOnWithThis(fn, count, vararg, rethrow) {
  return function (...values) {
    try {
      return vararg ? fn(this, ...values.slice(0, count - 1), values.slice(count - 1)) : fn(this, ...values);
    } catch (e) {
      rethrow(e);
    }
  };
}

/** CONSTRUCTOR under another name. */
function renamed(name, constructor) {
  return {
    [name]: function (marker, javaObject) {
      return constructor.call(this, marker, javaObject);
    },
  }[name];
}

/** The scripts that are in Java's class library, as far as the modules use it, by their parameters and texts. */
const SCRIPTS = {
  '(str) return str;': (str) => str,
  '(number) return number;': (number) => number,
  '() return navigator.hardwareConcurrency;': () => navigator.hardwareConcurrency,
};

/**
 * The last of TEXTS is the body, the others are the names of the parameters. All are asked for when the module is
 * loaded.
 */
function scriptOf(...texts) {
  const body = texts.pop();
  const key = `(${texts.join(', ')}) ${body}`;
  if (!Object.hasOwn(SCRIPTS, key)) throw new Error(`without-eval.mjs has to know the script ${key}`);
  return SCRIPTS[key];
}
