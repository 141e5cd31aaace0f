// Terminates a process started by a test.

/** Terminates the process, and kills it if it does not exit. */
export async function ended(process) {
  if (process.exitCode !== null || process.signalCode !== null || process.pid === undefined) return;
  const gone = new Promise((resolve) => process.once('exit', resolve));
  process.kill();
  const timer = setTimeout(() => process.kill('SIGKILL'), 5_000);
  await gone;
  clearTimeout(timer);
}
