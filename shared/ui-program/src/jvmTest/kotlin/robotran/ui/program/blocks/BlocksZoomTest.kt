package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTouchInput
import robotran.ui.program.keys
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.pass
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests that the text on blocks is scaled as that of the editor. */
@OptIn(ExperimentalTestApi::class)
class BlocksZoomTest {
    @Test
    fun `two fingers that move apart make the text larger, and carry no block`() =
        onPhoneInBlocks(PROGRAM) { workshop ->
            val before = workshop.state.settings.codeSize
            onNodeWithTag(ProgramTags.BLOCKS).performTouchInput {
                down(0, Offset(150f, 60f))
                down(1, Offset(200f, 60f))
                for (step in 1..10) {
                    updatePointerTo(0, Offset(150f - 6f * step, 60f))
                    updatePointerTo(1, Offset(200f + 6f * step, 60f))
                    move()
                }
                up(0)
                up(1)
            }
            pass(300)
            assertTrue(workshop.state.settings.codeSize > before, "${workshop.state.settings.codeSize}")
            assertEquals(PROGRAM, workshop.text)
        }

    @Test
    fun `Ctrl and the wheel change the size of the text, the wheel alone does not`() =
        onTabletInBlocks(PROGRAM) { workshop ->
            val before = workshop.state.settings.codeSize
            turnWheel(-1f)
            assertEquals(before, workshop.state.settings.codeSize)
            onNodeWithTag(ProgramTags.BLOCKS).performKeyInput { keyDown(Key.CtrlLeft) }
            turnWheel(-1f)
            val large = workshop.state.settings.codeSize
            assertTrue(large > before, "$large")
            repeat(2) { turnWheel(1f) }
            assertTrue(workshop.state.settings.codeSize < large)
            onNodeWithTag(ProgramTags.BLOCKS).performKeyInput { keyUp(Key.CtrlLeft) }
        }

    @Test
    fun `Ctrl and plus, minus and zero do the same`() = onTabletInBlocks(PROGRAM) { workshop ->
        focusBlocks()
        val before = workshop.state.settings.codeSize
        keys(listOf(Key.Plus, Key.Equals), with = Key.CtrlLeft)
        assertTrue(workshop.state.settings.codeSize > before)
        keys(listOf(Key.Zero), with = Key.CtrlLeft)
        assertEquals(before, workshop.state.settings.codeSize)
        keys(listOf(Key.Minus), with = Key.CtrlLeft)
        assertTrue(workshop.state.settings.codeSize < before)
        assertEquals(PROGRAM, workshop.text)
    }

    private fun ComposeUiTest.turnWheel(by: Float) {
        onNodeWithTag(ProgramTags.BLOCKS).performMouseInput {
            moveTo(Offset(150f, 60f))
            scroll(by)
        }
        pass(300)
    }

    private companion object {
        const val PROGRAM = "forward 20\nturn left 90\nbeep\n"
    }
}
