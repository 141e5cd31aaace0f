package robotran.ui.program.blocks

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ExperimentalTestApi
import robotran.ui.program.keys
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests blocks with a keyboard and without a pointer. */
@OptIn(ExperimentalTestApi::class)
class BlocksKeyboardTest {
    @Test
    fun `arrows walk, Enter edits, and digits and Enter change the number`() =
        onTabletInBlocks("beep\nforward 20\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown, Key.DirectionDown, Key.DirectionRight, Key.DirectionRight, Key.Enter))
            keys(listOf(Key.Three, Key.Five))
            assertEquals("beep\nforward 35\n", workshop.text)
            keys(listOf(Key.Enter))
            keys(listOf(Key.DirectionUp))
            keys(listOf(Key.Delete))
            assertEquals("forward 35\n", workshop.text)
        }

    @Test
    fun `Alt and arrows move a block, Ctrl D doubles it, Ctrl Z takes back`() = onTabletInBlocks("beep\nbuzz\n") {
        focusBlocks()
        keys(listOf(Key.DirectionDown))
        keys(listOf(Key.DirectionDown), with = Key.AltLeft)
        assertEquals("buzz\nbeep\n", it.text)
        keys(listOf(Key.D), with = Key.CtrlLeft)
        assertEquals("buzz\nbeep\nbeep\n", it.text)
        keys(listOf(Key.Z), with = Key.CtrlLeft)
        assertEquals("buzz\nbeep\n", it.text)
    }
}
