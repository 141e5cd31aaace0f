package robotran.tinyvm.programs

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.log.romCalls
import robotran.rcxrom.messages.BrickMessages
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Two bricks, each with one of two test programs that belong together, in sight of each other. */
class TwoBricksTest {
    private fun lastNumbers(programs: List<String>, mode: TinyVmMode): List<Int?> {
        val air = InfraredAir()
        val bricks = programs.map { path ->
            val linked = assertIs<TinyVmResult.Success>(link(path, mode = mode, speed = TinyVmSpeed.BRICK), path)
            RcxBrick(listOf(linked.program), air, messages = BrickMessages.of(Language.ENGLISH))
        }
        for (brick in bricks) {
            brick.press(BrickButton.RUN)
            brick.release(BrickButton.RUN)
        }
        repeat(LONGEST_MILLISECONDS) { for (brick in bricks) brick.tick() }
        return bricks.map { brick ->
            val calls = brick.log.entries.romCalls().filter { it.sourceLine > 0 }.map { it.call }
            val shown = calls.filter {
                it.address == RomAddress.SET_LCD_NUMBER && it.arguments.first() == RomCode.LCD_UNSIGNED
            }
            shown.lastOrNull()?.let { it.arguments[1] }
        }
    }

    @Test
    fun `bytes and packets get from one brick to the other in all ways of josx rcxcomm`() {
        for (mode in TinyVmMode.entries) {
            assertEquals(
                listOf<Int?>(ANSWERED_TWICE, SUM),
                lastNumbers(listOf("rcxcomm/TalksOnTheAir.java", "rcxcomm/HearsOnTheAir.java"), mode),
                "$mode",
            )
        }
    }

    private companion object {
        const val LONGEST_MILLISECONDS = 9_000

        /** One for the message and two for the bytes of the stream that are answered. */
        const val ANSWERED_TWICE = 3

        /** A message, two bytes of the stream, the last of a packet to all, the last of one with its sender. */
        const val SUM = 1 + (2 + 200) + 100 + (80 + 0x10)
    }
}
