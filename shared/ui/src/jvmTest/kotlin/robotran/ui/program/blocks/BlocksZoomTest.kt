package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performTouchInput
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
            onNodeWithTag("blocks").performTouchInput {
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

    private companion object {
        const val PROGRAM = "forward 20\nturn left 90\nbeep\n"
    }
}
