// Compiles Python for hubs with MicroPython's own compiler. The page loads this module with the first program that goes to a
// hub, in a script of its own: see docs/web-page.md.

/*!
 * @pybricks/mpy-cross-v6, with MicroPython
 *
 * MIT License
 *
 * Copyright (c) 2020-2022 The Pybricks Authors
 * Copyright (c) 2013-2022 Damien P. George
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy
 * of this software and associated documentation files (the "Software"), to deal
 * in the Software without restriction, including without limitation the rights
 * to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is
 * furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in all
 * copies or substantial portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 * IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 * FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 * LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 * OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
 * SOFTWARE.
 */
import startCompiler from '@pybricks/mpy-cross-v6/build/mpy-cross-v6.js';

const MODULE = new URL('@pybricks/mpy-cross-v6/build/mpy-cross-v6.wasm', import.meta.url).href;

/**
 * Compiles `source`, whose file is to be called `fileName`. Resolves to what the compiler ended with, the bytes if it wrote
 * some, and the lines that it printed about mistakes; is rejected if its module cannot be fetched.
 */
export const compile = (fileName, source) =>
  new Promise((resolve, reject) => {
    startCompiler({
      arguments: [fileName],
      inputFileContents: source,
      callback: (status, mpy, printed, errors) => resolve({ status, mpy: mpy ?? null, errors }),
      locateFile: () => MODULE,
      onAbort: (reason) => reject(new Error(String(reason))),
    }).catch(reject);
  });
