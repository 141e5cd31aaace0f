package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.programs.libraryClassFiles
import kotlin.random.Random

/**
 * Links and runs a program of [classes] with a [mutated] class file. Fails if the machine's state becomes invalid; false if it rejects the program.
 */
internal fun runMutant(classes: Map<String, ByteArray>, mainClass: String, random: Random): Boolean {
    val name = classes.keys.random(random)
    val bytes = mutated(classes.getValue(name), random)
    val mode = if (random.nextInt(8) == 0) TinyVmMode.FORGIVING else TinyVmMode.BRICK
    val result =
        linkTinyVm(
            "mutant",
            classes + (name to bytes),
            libraryClassFiles,
            mainClass,
            mode,
            messages = TinyVmMessages.of(Language.ENGLISH),
        )
    if (result is TinyVmResult.Success) run(result.program)
    return result is TinyVmResult.Success
}

/** A copy of [original] with one to three bytes changed, half of the time after its first third, where the code is. */
internal fun mutated(original: ByteArray, random: Random): ByteArray {
    val bytes = original.copyOf()
    repeat(1 + random.nextInt(3)) {
        val first = if (random.nextBoolean()) bytes.size / 3 else 8
        bytes[random.nextInt(first, bytes.size)] =
            if (random.nextInt(3) == 0) random.nextInt(12).toByte() else random.nextInt().toByte()
    }
    return bytes
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
