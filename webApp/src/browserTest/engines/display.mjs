// A virtual display, for browsers that need a display for WebGL.
import { spawn } from 'node:child_process';

/** Starts one. Returns its name for DISPLAY and a function that stops it. */
export async function startDisplay() {
  const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const number = await new Promise((resolve, reject) => {
    server.stdio[3].once('data', (line) => resolve(String(line).trim()));
    server.once('error', reject);
    server.once('exit', () => reject(new Error('Xvfb does not start')));
  });
  return { name: `:${number}`, stop: () => server.kill() };
}
