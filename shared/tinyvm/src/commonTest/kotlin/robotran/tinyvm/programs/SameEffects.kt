package robotran.tinyvm.programs

import robotran.brick.program.ProgramStatus
import robotran.brick.program.StatementWatch
import robotran.tinyvm.RecordingRom
import robotran.tinyvm.TinyVmProgram
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.TinyVmRun
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.testPrograms
import kotlin.random.Random
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * Runs test programs of the class library with a debugger, which takes stack code, and without, which takes register code.
 * Both runs must be in the same state after each of many short times.
 */
internal object SameEffects {
    /** The programs are dealt into so many shares. */
    const val SHARES = 4

    private class Observed(program: TinyVmProgram) {
        val rom = RecordingRom()
        val run = program.start(rom) as TinyVmRun

        /** Everything that must be the same, in a form that shows a difference. */
        fun state(status: ProgramStatus): String {
            val machine = run.machine
            return listOf(
                "$status, budget ${machine.budget}, statements ${run.statementsBegun}, ROM calls ${rom.calls.size}",
                machine.scheduler.threads.joinToString("\n") { thread(it) },
                "statics ${machine.statics.contentHashCode()}, free ${machine.heap.freeBytes}",
                "call stack ${run.callStack}, warnings ${run.remarks.size}",
            ).joinToString("\n")
        }

        private fun thread(thread: VmThread): String {
            val frames = thread.callStack.joinToString {
                "${it.method.name} ${it.next} ${it.base} ${it.top} ${it.lock}"
            }
            return "${thread.number} ${thread.state}: $frames: ${thread.stack.take(thread.usedWords)}"
        }
    }

    fun check(mode: TinyVmMode, speed: TinyVmSpeed, shares: IntRange) {
        val random = Random(8)
        val programs = testPrograms.keys.sorted().filterIndexed {
            place,
            _,
            ->
            place % SHARES in shares
        }.mapNotNull { path ->
            (link(path, mode = mode, speed = speed) as? TinyVmResult.Ready)?.let { path to it.program }
        }
        assertTrue(programs.size > 20 * shares.count(), "There are only ${programs.size} programs.")
        for ((path, program) in programs) compare(path, program, speed, random)
    }

    private fun compare(path: String, program: TinyVmProgram, speed: TinyVmSpeed, random: Random) {
        val maxSteps = if (speed == TinyVmSpeed.BRICK) BRICK_STEPS else UNLIMITED_STEPS
        val fast = Observed(program)
        val debugged = Observed(program)
        debugged.run.watch = StatementWatch { false }
        for (round in 1..ROUNDS) {
            val steps = random.nextInt(1, maxSteps + 1)
            val states = listOf(fast, debugged).map {
                it.rom.milliseconds += if (round % 8 == 0) 100 else 1
                it.rom.sensorValue = round % 3
                it.state(it.run.resume(steps))
            }
            assertEquals(states[1], states[0], "$path, round $round, $steps steps")
            if (states[0].startsWith("Ended")) break
        }
        assertEquals(debugged.rom.calls, fast.rom.calls, path)
        val heaps = listOf(fast, debugged).map { it.run.machine.heap.words }
        assertTrue(heaps[0].contentEquals(heaps[1]), "$path: the heaps differ")
    }

    private const val ROUNDS = 150

    /** The most steps of a round: some 240 bytecodes at the brick's speed. */
    private const val BRICK_STEPS = 30

    /** Up to 15,000 bytecodes at full speed, enough for any mistake in a loop to show, and few enough for wasm. */
    private const val UNLIMITED_STEPS = 3
}
