package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTouchInput
import robotran.robolang.words.BlockGroup
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.isThere
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.ui.screen.touch
import robotran.uikit.*
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests what is carried by a finger or a mouse: values, several blocks, and where they go. */
@OptIn(ExperimentalTestApi::class)
class CarryingTest {
    @Test
    fun `a value is carried from one block into another`() = onTabletInBlocks(READS) {
        carry(socketOf(READS, "light"), placeOf(socketOf(READS, "90")).center)
        assertEquals("forward 20\nturn left light\n", it.text)
    }

    @Test
    fun `a value goes into the socket that is near the finger`() = onTabletInBlocks(READS) {
        carry(socketOf(READS, "light"), placeOf(socketOf(READS, "90")).bottomCenter + Offset(0f, 8f))
        assertEquals("forward 20\nturn left light\n", it.text)
    }

    @Test
    fun `a value that is let go beside the sockets stays where it was`() = onTabletInBlocks(READS) {
        carry(socketOf(READS, "light"), placeOf(ProgramTags.block("1")).centerRight + Offset(200f, 0f))
        assertEquals(READS, it.text)
    }

    @Test
    fun `a plain number belongs to its block, which is carried with it`() = onTabletInBlocks(READS) {
        carry(socketOf(READS, "90"), placeOf(ProgramTags.block("0")).topLeft + Offset(60f, 6f))
        assertEquals("turn left 90\nforward light\n", it.text)
    }

    @Test
    fun `the bin appears while something is carried, moves nothing, and deletes it`() =
        onPhoneInBlocks("beep\nbuzz\n") { workshop ->
            val before = placeOf(ProgramTags.block("1"))
            assertTrue(onAllNodesWithTag(ProgramTags.BLOCKS_BIN).fetchSemanticsNodes().isEmpty())
            carry(ProgramTags.block("0"), placeOf(ProgramTags.block("1")).center, holds = true)
            assertEquals(before, placeOf(ProgramTags.block("1")))
            val list = placeOf(ProgramTags.BLOCKS).topLeft
            val bin = placeOf(ProgramTags.BLOCKS_BIN).center
            onNodeWithTag(ProgramTags.BLOCKS).performTouchInput { moveTo(bin - list) }
            pass(100)
            letGo()
            assertEquals("buzz\n", workshop.text)
            assertTrue(onAllNodesWithTag(ProgramTags.BLOCKS_BIN).fetchSemanticsNodes().isEmpty())
            touch(ProgramTags.UNDO)
            assertEquals("beep\nbuzz\n", workshop.text)
        }

    @Test
    fun `a value of the palette goes into a socket, by a finger that carries it or by a touch`() =
        onTabletInBlocks("forward 20\nturn left 90\n") { workshop ->
            scrollAndTouch(ProgramTags.group(BlockGroup.SENSE))
            scrollTo(ProgramTags.take("value-light"))
            carryNew(ProgramTags.take("value-light"), placeOf(socketOf(workshop.text, "20")).center)
            assertEquals("forward light\nturn left 90\n", workshop.text)
            touch(socketOf(workshop.text, "90"))
            touch(ProgramTags.BLOCK_SHEET_CLOSE)
            scrollAndTouch(ProgramTags.group(BlockGroup.SENSE))
            scrollAndTouch(ProgramTags.take("value-timer"))
            assertEquals("forward light\nturn left timer\n", workshop.text)
        }

    @Test
    fun `a new block that is let go beside the blocks or above them is not added`() {
        onScreen(820, 960) { workshop ->
            showInBlocks(workshop, "beep\n")
            scrollAndTouch(ProgramTags.group(BlockGroup.DRIVE))
            val list = placeOf(ProgramTags.BLOCKS)
            val sheet = placeOf(ProgramTags.BLOCK_SHEET)
            assertTrue(sheet.left >= list.right, "$sheet, $list")
            val beside = Offset(sheet.center.x, list.center.y)
            val above = Offset(list.center.x, list.top - 200f)
            for (place in listOf(beside, above)) {
                carryNew(ProgramTags.take("move"), place)
                assertEquals("beep\n", workshop.text, "$place of $list")
            }
            carryNew(ProgramTags.take("move"), list.center)
            assertEquals("beep\nforward 20\n", workshop.text)
        }
        onTabletInBlocks("beep\n") { workshop ->
            scrollAndTouch(ProgramTags.group(BlockGroup.DRIVE))
            val list = placeOf(ProgramTags.BLOCKS)
            carryNew(ProgramTags.take("move"), Offset(list.right + 100f, list.top + 100f))
            assertEquals("beep\n", workshop.text)
        }
    }

    @Test
    fun `a new block is carried out of a palette that covers the blocks`() = onScreen(640, 360) { workshop ->
        showInBlocks(workshop, "beep\n")
        touch(ProgramTags.BLOCKS_ADD)
        val list = placeOf(ProgramTags.BLOCKS)
        carryNew(ProgramTags.take("move"), Offset(list.center.x, list.bottom - 8f))
        assertEquals("beep\nforward 20\n", workshop.text)
    }

    /** A finger rests on [tag] of the palette until it carries, moves to [to] of the screen, and goes up. */
    private fun ComposeUiTest.carryNew(tag: String, to: Offset) {
        val from = placeOf(tag).topLeft
        onNodeWithTag(tag).performTouchInput { down(center) }
        pass(800)
        onNodeWithTag(tag).performTouchInput { moveTo(to - from) }
        pass(100)
        onNodeWithTag(tag).performTouchInput { up() }
        pass(200)
    }

    @Test
    fun `a touch on a value of the palette says what to do if there is no place for it`() =
        onPhoneInBlocks("forward 20\n") { workshop ->
            touch(ProgramTags.BLOCKS_ADD)
            scrollAndTouch(ProgramTags.group(BlockGroup.SENSE))
            scrollAndTouch(ProgramTags.take("value-light"))
            assertEquals("forward 20\n", workshop.text)
            assertFalse(isThere(ProgramTags.BLOCK_SHEET), "the program, where the value may go, is in sight")
            assertTrue(placeOf(ProgramTags.BLOCKS_ERROR).top > placeOf(ProgramTags.block("0")).bottom)
        }

    @Test
    fun `several blocks are chosen by touch and carried together`() = onPhoneInBlocks("beep\nbuzz\nstop\n") {
        touch(ProgramTags.block("0"))
        touch(ProgramTags.BLOCK_MORE)
        touch(ProgramTags.ACTIONS_MORE)
        scrollAndTouch(ProgramTags.action(ProgramTags.CHOOSE))
        touch(ProgramTags.block("1"))
        carry(ProgramTags.block("0"), placeOf(ProgramTags.block("2")).bottomLeft + CLEAR)
        assertEquals("stop\nbeep\nbuzz\n", it.text)
        touch(ProgramTags.CHOOSING_DONE)
        assertTrue(onAllNodesWithTag(ProgramTags.BLOCKS_CHOOSING).fetchSemanticsNodes().isEmpty())
    }

    @Test
    fun `a block with all below it is carried as a stack`() = onTabletInBlocks(NESTED) {
        touch(ProgramTags.block("1"))
        touch(ProgramTags.BLOCK_MORE)
        touch(ProgramTags.ACTIONS_MORE)
        scrollAndTouch(ProgramTags.action(ProgramTags.STACK))
        carry(ProgramTags.block("1"), placeOf(ProgramTags.block("0-end")).bottomLeft + CLEAR)
        assertEquals("repeat 2 times\nend\nbeep\nbuzz\n", it.text)
    }

    @Test
    fun `a mouse carries at once, and Shift and a click select all up to a block`() =
        onTabletInBlocks("beep\nbuzz\nstop\n") { workshop ->
            touch(ProgramTags.block("0"))
            onNodeWithTag(ProgramTags.BLOCKS).performKeyInput { keyDown(Key.ShiftLeft) }
            onNodeWithTag(ProgramTags.block("1")).performMouseInput { click() }
            onNodeWithTag(ProgramTags.BLOCKS).performKeyInput { keyUp(Key.ShiftLeft) }
            pass(200)
            assertEquals(2, workshop.state.programs.blocks?.selected?.size)
            val list = placeOf(ProgramTags.BLOCKS).topLeft
            val from = placeOf(ProgramTags.block("0")).centerLeft + Offset(40f, 0f)
            val to = placeOf(ProgramTags.block("2")).bottomLeft + CLEAR
            onNodeWithTag(ProgramTags.BLOCKS).performMouseInput {
                moveTo(from - list)
                press()
                moveTo(from - list + Offset(30f, 0f))
                moveTo(to - list)
                release()
            }
            pass(200)
            assertEquals("stop\nbeep\nbuzz\n", workshop.text)
        }

    @Test
    fun `the list scrolls while a finger waits at its lower edge`() = onTabletInBlocks(LONG) {
        val list = placeOf(ProgramTags.BLOCKS)
        carry(ProgramTags.block("0"), list.bottomLeft + Offset(160f, -8f), holds = true)
        pass(3_000)
        assertTrue(onAllNodesWithTag(ProgramTags.block("1")).fetchSemanticsNodes().isEmpty())
        letGo()
        assertFalse(it.text.startsWith("forward 1\n"))
    }

    private companion object {
        const val READS = "forward light\nturn left 90\n"
        const val NESTED = "repeat 2 times\n  beep\n  buzz\nend\n"
        val LONG = (1..60).joinToString("\n", postfix = "\n") { "forward $it" }

        /** Below the middle of a block. */
        val CLEAR = Offset(60f, -4f)
    }
}
