package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import robotran.rcxrom.RcxBrick
import robotran.tinyvm.config.TinyVmCosts
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests that busy loops take as long as [TinyVmCosts] says. */
class CostsTest {
    /** The milliseconds that a brick needs for [ROUNDS] rounds of a loop over [body]. */
    private fun millisecondsOf(body: String): Long {
        val program = linked(program("for (int i = 0; i < $ROUNDS; i++) { $body }", MEMBERS))
        val ran = run(program, steps = RcxBrick.STEPS_PER_MILLISECOND)
        assertEquals(ProgramStatus.Ended, ran.status)
        return ran.rom.milliseconds
    }

    private fun assertBytecodesInARound(expected: Int, body: String) {
        val milliseconds = expected * ROUNDS / TinyVmCosts.BYTECODES_PER_MILLISECOND
        val measured = millisecondsOf(body)
        assertTrue(measured in milliseconds..milliseconds + 5, "$measured ms instead of $milliseconds: $body")
    }

    @Test
    fun `an empty loop takes five bytecodes a round`() = assertBytecodesInARound(LOOP, "")

    @Test
    fun `whole numbers and decimal ones take the same`() {
        assertBytecodesInARound(LOOP + 4, "sum = sum + i;")
        assertBytecodesInARound(LOOP + 4, "product = product * 0.5f;")
    }

    @Test
    fun `a call takes its bytecodes and the return`() = assertBytecodesInARound(LOOP + 2, "nothing();")

    @Test
    fun `a native method takes the call and what the table says`() =
        assertBytecodesInARound(LOOP + 2 + TinyVmCosts.NATIVE_METHOD, "Thread.currentThread();")

    @Test
    fun `a routine of the ROM takes the native method and what the table says`() = assertBytecodesInARound(
        LOOP + 2 + TinyVmCosts.NATIVE_METHOD + TinyVmCosts.ROM_ROUTINE,
        "ROM.call((short) 0x27c8);",
    )

    private companion object {
        const val ROUNDS = 4_000

        /** Load, constant, comparison, increment and jump, as the JDK's compiler writes a loop. */
        const val LOOP = 5

        const val MEMBERS = "static int sum; static float product = 1f; static void nothing() { }"
    }
}
