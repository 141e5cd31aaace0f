package robotran.programs

import robotran.language.Language
import robotran.rcxrom.program.RcxProgram
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** The virtual machine makes the ROM calls that leJOS's own machine made of the same class files. */
class OriginalMachineTest {
    private fun link(name: String): RcxProgram {
        val result = linkTinyVm(
            name,
            OriginalCalls.programs,
            OriginalCalls.library,
            name,
            TinyVmMode.BRICK,
            speed = TinyVmSpeed.BRICK,
            messages = TinyVmMessages.of(Language.ENGLISH),
        )
        return assertIs<TinyVmResult.Success>(result, "$name: $result").program
    }

    private fun differenceOf(name: String, original: OriginalRun): String? {
        val ours = CallRecorder(link(name), ::originalSensors)
        ours.run(MILLISECONDS)
        val calls = if (original.isCut) ours.calls.take(original.calls.size) else ours.calls
        val (ownValues, originalValues) = listOf(calls, original.calls).map { it.drop(SETTLING_CALLS[name] ?: 0) }
        val same = ownValues.zip(originalValues).takeWhile { (one, other) -> isSame(one, other, LATER[name] ?: 1) }.size
        return when {
            same < ownValues.size || same < originalValues.size -> {
                "after $same calls ${ownValues.drop(same).take(2)} instead of ${originalValues.drop(same).take(2)}"
            }

            calls.size != original.calls.size -> "${calls.size} calls instead of ${original.calls.size}"

            ours.failures.map { it.second } != original.exceptions -> {
                "exceptions ${ours.failures}, not ${original.exceptions}"
            }

            else -> null
        }
    }

    /** A millisecond may begin a bytecode earlier or later. */
    private fun isSame(one: TimedCall, other: TimedCall, milliseconds: Int) =
        one.call == other.call && abs(one.milliseconds - other.milliseconds) <= milliseconds

    @Test
    fun `every program makes the calls of the original machine`() {
        val differences = OriginalCalls.calls.mapNotNull { (name, original) ->
            differenceOf(name, original)?.let { "$name: $it" }
        }
        assertEquals("", differences.joinToString("\n"))
        assertTrue(OriginalCalls.calls.size >= MIN_PROGRAMS, "${OriginalCalls.calls.size} programs")
    }

    private companion object {
        const val MILLISECONDS = 20_000L
        const val MIN_PROGRAMS = 22

        /**
         * How many milliseconds later calls may be. DataLogger: a brick shows the exception until On-Off is pressed, the
         * emulator prints it. WallBouncer: the thread for listeners has its turn before the first call here, and between
         * the first two calls there.
         */
        val LATER = mapOf("DataLogger" to 2, "WallBouncer" to 2)

        /** Our light sensor needs a moment after it was powered; the original emulator's values are fixed. */
        val SETTLING_CALLS = mapOf("LightMeter" to 1)
    }
}
