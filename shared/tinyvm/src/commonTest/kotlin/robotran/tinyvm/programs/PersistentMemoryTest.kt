package robotran.tinyvm.programs

import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.log.romCalls
import robotran.rcxrom.messages.BrickMessages
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmMode
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** A program that keeps bytes in the front of the memory for objects, run twice on the same brick. */
class PersistentMemoryTest {
    /** The numbers that each of two runs shows. */
    private fun shown(mode: TinyVmMode, between: RcxBrick.() -> Unit): List<List<Int>> {
        val linked = assertIs<TinyVmResult.Success>(link("rcx/PersistentMemory.java", mode = mode))
        val brick = RcxBrick(listOf(linked.program), messages = BrickMessages.of(Language.ENGLISH))
        return List(2) { run ->
            if (run == 1) brick.between()
            val before = brick.log.entries.size
            brick.press(BrickButton.RUN)
            brick.release(BrickButton.RUN)
            while (brick.state.run is RunState.Running) brick.tick()
            brick.log.entries.drop(before).romCalls().map { it.call }.filter {
                it.address == RomAddress.SET_LCD_NUMBER && it.arguments.first() == RomCode.LCD_UNSIGNED
            }.map { it.arguments[1] }
        }
    }

    @Test
    fun `the bytes are still there when the program runs again`() {
        for (mode in TinyVmMode.entries) {
            val (first, second) = shown(mode) { }
            assertEquals(listOf(2040, 1, 0, 77, 3), first, "$mode")
            assertEquals(listOf(2040, 1, 77, 77, 3), second, "$mode")
        }
    }

    @Test
    fun `the bytes are still there after the brick was switched off`() {
        val runs = shown(TinyVmMode.BRICK) {
            repeat(2) {
                press(BrickButton.ON_OFF)
                release(BrickButton.ON_OFF)
                repeat(1000) { tick() }
            }
        }
        assertEquals(listOf(2040, 1, 77, 77, 3), runs[1])
    }
}
