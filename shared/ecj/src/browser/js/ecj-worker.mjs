// Compiles Java beside the page, which stays alive meanwhile and ends this worker if that takes too long. The other side is
// `WorkerEcj` of shared/java-compiler. A worker for webpack, which bundles it.
import { loadModule } from './ecj.mjs';

const list = (count, of) => Array.from({ length: count }, (_, index) => of(index));

const classesOf = (ecj) =>
  list(ecj.classCount(), (index) => ({
    name: ecj.className(index),
    bytes: Int8Array.from(ecj.classFile(index)),
    hasMain: ecj.classHasMain(index),
  }));

const problemsOf = (ecj) =>
  list(ecj.problemCount(), (index) => ({
    path: ecj.problemPath(index),
    number: ecj.problemNumber(index),
    isError: ecj.problemIsError(index),
    isSyntax: ecj.problemIsSyntax(index),
    start: ecj.problemStart(index),
    end: ecj.problemEnd(index),
    message: ecj.problemMessage(index),
    arguments: list(ecj.problemArgumentCount(index), (argument) => ecj.problemArgument(index, argument)),
    members: list(ecj.problemMemberCount(index), (member) => ecj.problemMember(index, member)),
  }));

function compile(ecj, { target, library, gaps, sources }) {
  ecj.setTarget(target);
  if (library) {
    ecj.clearLibrary();
    for (const [name, bytes] of library) ecj.addLibraryClass(name, bytes);
  }
  for (const key of gaps) ecj.addGap(key);
  for (const [path, text] of sources) ecj.addSource(path, text);
  const completed = ecj.compile();
  return { kind: 'compiled', completed, classes: classesOf(ecj), problems: problemsOf(ecj) };
}

const failed = (error) => postMessage({ kind: 'failed', text: String((error && error.message) || error) });

const loading = loadModule();
loading.then(() => postMessage({ kind: 'ready' }), failed);
addEventListener('message', async ({ data }) => {
  try {
    postMessage(compile(await loading, data));
  } catch (error) {
    failed(error);
  }
});
