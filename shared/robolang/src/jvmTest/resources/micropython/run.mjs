// Runs programs in MicroPython on the fake modules beside this file.
// usage: node run.mjs MICROPYTHON.mjs PROGRAMS.json, where each program has a name and a text;
// prints a line for each program: its name and its log, with tabs between.
import { existsSync, readFileSync, readdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'

const [, , micropython, programs] = process.argv
const here = dirname(fileURLToPath(import.meta.url))
const { loadMicroPython } = await import(pathToFileURL(micropython))

/** An interpreter with the fake modules; its memory is that of many hubs, for it keeps what programs leave behind. */
async function interpreter() {
    const python = await loadMicroPython({ heapsize: 8 * 1024 * 1024, stdout: () => {} })
    python.FS.mkdir('/fakes')
    python.FS.mkdir('/fakes/pybricks')
    for (const folder of ['', 'pybricks/'].filter(name => existsSync(join(here, name)))) {
        for (const file of readdirSync(join(here, folder)).filter(name => name.endsWith('.py'))) {
            python.FS.writeFile('/fakes/' + folder + file, readFileSync(join(here, folder, file)))
        }
    }
    python.runPython('import sys\nsys.path.insert(0, "/fakes")\nfrom fake_run import run\nimport json\n')
    return python
}

const PROGRAMS_PER_INTERPRETER = 40
const logs = {}
let python = null
let runs = 0
for (const { name, text } of JSON.parse(readFileSync(programs, 'utf8'))) {
    if (runs++ % PROGRAMS_PER_INTERPRETER === 0) python = await interpreter()
    try {
        python.globals.set('text', text)
        python.runPython('result = json.dumps(run(text))')
        logs[name] = JSON.parse(python.globals.get('result'))
    } catch (failure) {
        logs[name] = ['# broken ' + (failure.message ?? failure)]
        python = await interpreter()
    }
}
const oneLine = text => text.replace(/[\t\n]/g, ' ')
process.stdout.write(Object.entries(logs).map(([name, log]) => [name, ...log].map(oneLine).join('\t') + '\n').join(''))
