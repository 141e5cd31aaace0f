package robotran.workshop.blocks

import robotran.workshop.event.BlockEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class BlockSelectingTest {
    @Test
    fun `a selection grows and shrinks around the block that was chosen first`() =
        onBlocks("beep\nbuzz\nstop\nforward 20\n") {
            goTo("buzz")
            send(BlockEvent.SelectedTo(block("forward 20")))
            assertEquals(listOf("buzz", "stop", "forward 20"), chosen)
            send(BlockEvent.SelectedTo(block("stop")))
            assertEquals(listOf("buzz", "stop"), chosen)
            send(BlockEvent.SelectedTo(block("beep")))
            assertEquals(listOf("beep", "buzz"), chosen)
        }

    @Test
    fun `a block with all below it is a stack`() = onBlocks("beep\nrepeat 2 times\n  buzz\n  stop\nend\n") {
        send(BlockEvent.StackSelected(block("buzz")))
        assertEquals(listOf("buzz", "stop"), chosen)
        drag(
            DragPayload.Blocks(state.runOf(block("buzz"))),
            BlockTarget.Between(checkNotNull(state.program.endOf(null))),
        )
        assertEquals("beep\nrepeat 2 times\nend\nbuzz\nstop\n", text)
    }

    @Test
    fun `choosing several ends when they are deleted`() = onBlocks("beep\nbuzz\nstop\n") {
        goTo("beep")
        send(BlockEvent.MultiSelectChanged(true))
        send(BlockEvent.SelectedTo(block("buzz")))
        assertTrue(state.isChoosing)
        drag(DragPayload.Blocks(state.runOf(block("beep"))), BlockTarget.Bin)
        assertFalse(state.isChoosing)
    }

    @Test
    fun `blocks leave the block around and enter the one above`() =
        onBlocks("repeat 2 times\n  beep\n  buzz\nend\nstop\n") {
            goTo("beep")
            send(BlockEvent.Nested(isOut = true))
            assertEquals("repeat 2 times\n  buzz\nend\nbeep\nstop\n", text)
            send(BlockEvent.Nested(isOut = false))
            assertEquals("repeat 2 times\n  buzz\n  beep\nend\nstop\n", text)
            goTo("repeat 2 times")
            send(BlockEvent.Nested(isOut = true))
            send(BlockEvent.Nested(isOut = false))
            assertEquals("repeat 2 times\n  buzz\n  beep\nend\nstop\n", text)
        }

    @Test
    fun `an edit says what it has done`() = onBlocks("beep\nrepeat 2 times\nend\n") {
        goTo("beep")
        send(BlockEvent.Moved(isUp = false))
        assertEquals("Moved: beep, 1 of 1 in repeat 2 times", state.said)
    }

    @Test
    fun `a pasted value replaces the value with the cursor, other text becomes blocks`() = onBlocks("forward 20\n") {
        open("forward 20", "20")
        send(BlockEvent.DialogShown(null))
        send(BlockEvent.Pasted("light + 1\n"))
        assertEquals("forward light + 1\n", text)
        send(BlockEvent.Pasted("beep\nbuzz"))
        assertEquals("forward light + 1\nbeep\nbuzz\n", text)
        send(BlockEvent.Pasted("dear robot, please dance"))
        assertEquals("forward light + 1\nbeep\nbuzz\ndear robot, please dance\n", text)
        assertEquals("dear robot, please dance", row)
    }

    private val OnBlocks.chosen: List<String>
        get() = state.selected.mapNotNull { state.program[it] }.map { it.head.span.textIn(text).trim() }
}
