package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.programs.libraryClassFiles
import kotlin.random.Random

/**
 * Links and runs a program of [classes] with one to three bytes of a class file changed, half of the time after its
 * first third, where the code is. Fails if the machine's state becomes invalid; false if it rejects the program.
 */
internal fun runMutant(classes: Map<String, ByteArray>, mainClass: String, random: Random): Boolean {
    val name = classes.keys.random(random)
    val bytes = classes.getValue(name).copyOf()
    repeat(1 + random.nextInt(3)) {
        val first = if (random.nextBoolean()) bytes.size / 3 else 8
        bytes[random.nextInt(first, bytes.size)] =
            if (random.nextInt(3) == 0) random.nextInt(12).toByte() else random.nextInt().toByte()
    }
    val mode = if (random.nextInt(8) == 0) TinyVmMode.FORGIVING else TinyVmMode.BRICK
    val result = linkTinyVm("mutant", classes + (name to bytes), libraryClassFiles, mainClass, mode)
    if (result is TinyVmResult.Ready) run(result.program)
    return result is TinyVmResult.Ready
}

private fun run(program: TinyVmProgram) {
    val rom = RecordingRom()
    val run = program.start(rom)
    for (round in 1..ROUNDS) {
        rom.milliseconds += 2
        val status = run.resume(STEPS)
        if (status == ProgramStatus.Ended || status is ProgramStatus.Failed) break
    }
    for (thread in run.threads) {
        thread.callStack.indices.take(LOOKED_INTO).forEach {
            run.variablesOf(thread.number, it)
        }
    }
    checkHeap(run)
}

private const val ROUNDS = 20
private const val STEPS = 50
private const val LOOKED_INTO = 3
