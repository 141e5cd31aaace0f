package robotran.workshop.blocks

import robotran.workshop.event.BlockEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class BlockStepsTest {
    @Test
    fun `down and up walk over all rows, but not over the room in an empty branch`() = onBlocks(CHOICE) {
        val down = generateSequence { step(BlockStep.DOWN) }.take(6).toList()
        assertEquals(listOf("if left bumper", "beep", "else", "end", "forward 20 + 5", "forward 20 + 5"), down)
        val up = generateSequence { step(BlockStep.UP) }.take(5).toList()
        assertEquals(listOf("end", "else", "beep", "if left bumper", "if left bumper"), up)
    }

    @Test
    fun `right walks into the parts of a line, each value before its own parts, and left back`() = onBlocks(CHOICE) {
        send(BlockEvent.Stepped(BlockStep.LAST))
        val parts = generateSequence { part(BlockStep.RIGHT) }.take(6).toList()
        assertEquals(listOf("forward", "20 + 5", "20", "+", "5", "5"), parts)
        repeat(5) { send(BlockEvent.Stepped(BlockStep.LEFT)) }
        assertNull(state.part)
        assertEquals("forward 20 + 5", row)
    }

    @Test
    fun `left leaves the block around`() = onBlocks(CHOICE) {
        goTo("beep")
        assertEquals("if left bumper", step(BlockStep.LEFT))
        assertEquals("if left bumper", step(BlockStep.LEFT))
    }

    @Test
    fun `moving a block row by row leads it through each place`() = onBlocks("beep\nif left bumper\nelse\nend\n") {
        goTo("beep")
        val places = generateSequence {
            send(BlockEvent.Moved(isUp = false))
            text
        }.take(3).toList()
        assertEquals(
            listOf(
                "if left bumper\n  beep\nelse\nend\n",
                "if left bumper\nelse\n  beep\nend\n",
                "if left bumper\nelse\nend\nbeep\n",
            ),
            places,
        )
        repeat(3) { send(BlockEvent.Moved(isUp = true)) }
        assertEquals("beep\nif left bumper\nelse\nend\n", text)
    }

    @Test
    fun `neighbours are selected together and move together`() = onBlocks("beep\nbuzz\nstop\n") {
        goTo("beep")
        send(BlockEvent.SelectedTo(block("buzz")))
        send(BlockEvent.Moved(isUp = false))
        assertEquals("stop\nbeep\nbuzz\n", text)
        assertEquals(2, state.selected.size)
    }

    private fun OnBlocks.step(step: BlockStep): String? {
        send(BlockEvent.Stepped(step))
        return row
    }

    private fun OnBlocks.part(step: BlockStep): String? {
        send(BlockEvent.Stepped(step))
        return part
    }

    private companion object {
        const val CHOICE = "if left bumper\n  beep\nelse\nend\nforward 20 + 5\n"
    }
}
