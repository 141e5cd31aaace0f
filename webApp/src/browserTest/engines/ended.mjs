// Ends a process that a test has started.

/** Asks it to end, and sees to it that it has. */
export async function ended(process) {
  if (process.exitCode !== null || process.signalCode !== null || process.pid === undefined) return;
  const gone = new Promise((resolve) => process.once('exit', resolve));
  process.kill();
  const timer = setTimeout(() => process.kill('SIGKILL'), 5_000);
  await gone;
  clearTimeout(timer);
}
