package robotran.benchmarks

import robotran.brick.program.ProgramStatus
import robotran.rcxrom.RcxBrick
import robotran.tinyvm.config.TinyVmCosts

/**
 * Loops of each kind at the speed of a brick: the bytecodes and the virtual milliseconds that a thousand rounds take, and
 * how much faster than a brick this machine runs them.
 */
internal suspend fun busyLoops(): Measurement {
    val loops = BUSY_LOOPS.map { (kind, body) -> measureLoop(kind, body) }
    val ratio = loops.sumOf { it.milliseconds } / loops.sumOf { it.realMilliseconds }
    return Measurement(
        TinyVmCosts.BYTECODES_PER_MILLISECOND.toDouble(),
        "bytecodes/ms of a brick, ${rounded(ratio)} times as fast here",
        loops.joinToString("; ") { it.text },
    )
}

private class BusyLoop(val kind: String, val milliseconds: Double, val realMilliseconds: Double) {
    val text: String
        get() {
            val bytecodes = milliseconds * TinyVmCosts.BYTECODES_PER_MILLISECOND / ROUNDS
            return "$kind: ${rounded(bytecodes)} bytecodes a round, ${rounded(milliseconds / THOUSANDS)} ms for a " +
                "thousand, ${rounded(milliseconds / realMilliseconds)} times as fast here"
        }
}

private suspend fun measureLoop(kind: String, body: String): BusyLoop {
    val program = javaProgramOf("Busy.java", busyProgram(body))
    val rom = SilentRom()
    val seconds = seconds {
        rom.milliseconds = 0
        val run = program.start(rom)
        while (run.resume(RcxBrick.STEPS_PER_MILLISECOND) == ProgramStatus.Running) rom.milliseconds++
    }
    return BusyLoop(kind, rom.milliseconds.toDouble(), seconds * MILLISECONDS_IN_A_SECOND)
}

private fun busyProgram(body: String) =
    """
    import josx.platform.rcx.ROM;

    public class Busy {
        private static int sum;
        private static float product = 1f;
        private static int[] numbers = new int[8];
        private int field;

        public static void main(String[] args) {
            Busy busy = new Busy();
            for (int index = 0; index < $ROUNDS; index++) { $body }
        }

        static void callStatic() {
        }

        void call() {
        }
    }
    """.trimIndent()

private val BUSY_LOOPS = mapOf(
    "empty" to "",
    "whole numbers" to "sum = sum * 31 + index;",
    "decimal numbers" to "product = product * 0.5f + 1f;",
    "array" to "numbers[index & 7] = index;",
    "field" to "busy.field = busy.field + 1;",
    "static call" to "callStatic();",
    "call" to "busy.call();",
    "native method" to "Thread.currentThread();",
    "ROM routine" to "ROM.call((short) 0x27c8);",
)

private const val ROUNDS = 20_000
private const val THOUSANDS = ROUNDS / 1_000
private const val MILLISECONDS_IN_A_SECOND = 1_000
