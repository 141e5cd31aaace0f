package robotran.workshop.blocks

import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.blockediting.BlockEdit
import robotran.blockediting.palette.Palette
import robotran.robolang.outline.PhrasePart
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BlockEventsPropertyTest {
    @Test
    fun `whatever somebody does to blocks, they are those of the text, and undo leads back`() = runBlocking<Unit> {
        checkAll(150, Arb.list(Arb.int(0..<CHOICES), 0..40)) { choices ->
            onBlocks(PROGRAM) {
                for (choice in choices) {
                    send(eventFor(choice))
                    checkBlocks()
                }
                while (workshop.state.programs.canUndo && text != PROGRAM) {
                    send(ProgramEvent.Undone)
                    checkBlocks()
                }
                assertEquals(PROGRAM, text)
            }
        }
    }

    private fun OnBlocks.checkBlocks() {
        assertEquals(text, state.program.text)
        state.cursor?.let { assertTrue(state.program[it.block] != null, "the cursor is at no block") }
        assertTrue(state.selected.all { state.program[it] != null }, "a block is selected that is not there")
        val part = (state.sheet as? BlockDialog.Part)?.span
        if (part != null) assertTrue(state.program.partAt(part) != null, "the sheet is about nothing")
    }

    /** An event that suits the state; the same for the same [choice] and state. */
    private fun OnBlocks.eventFor(choice: Int): BlockEvent {
        val random = choice / KINDS
        val row = state.list.rows.elementAtOrNull(random % (state.list.rows.size + 1))
        val parts = row?.line?.editableParts.orEmpty()
        val palette = Palette.blocks
        return when (choice % KINDS) {
            0 -> BlockEvent.CursorPut(row?.cursor)
            1 -> BlockEvent.Taken(palette[random % palette.size])
            2 -> BlockEvent.Moved(isUp = random % 2 == 0)
            3 -> BlockEvent.DialogShown(parts.getOrNull(random % (parts.size + 1))?.let { BlockDialog.Part(it.span) })
            4 -> BlockEvent.Put(TEXTS[random % TEXTS.size])
            5 -> BlockEvent.Edited(BlockEdit.Delete(state.selected.toSet()))
            6 -> row?.let { BlockEvent.Folded(it.block.id) } ?: BlockEvent.ErrorDismissed
            7 -> BlockEvent.Stepped(BlockStep.entries[random % BlockStep.entries.size])
            8 -> row?.let { BlockEvent.SelectedTo(it.block.id) } ?: BlockEvent.ErrorDismissed
            9 -> dragTo(row)
            10 -> dragValue(random)
            11 -> dragIntoBin(row)
            12 -> BlockEvent.Nested(isOut = random % 2 == 0)
            13 -> BlockEvent.Pasted(PASTED[random % PASTED.size])
            14 -> row?.let { BlockEvent.StackSelected(it.block.id) } ?: BlockEvent.MultiSelectChanged(random % 2 == 0)
            else -> BlockEvent.DialogShown(null)
        }
    }

    /** Carries a value of the program, or of the palette, over one of the values. */
    private fun OnBlocks.dragValue(random: Int): BlockEvent {
        val values = state.program.outline.lines.flatMap { it.editableParts }.filterIsInstance<PhrasePart.Value>()
        if (values.isEmpty()) return BlockEvent.ErrorDismissed
        val to = BlockTarget.Socket(values[random % values.size].span)
        val fresh = Palette.blocks.filter { it.isValue }
        val load = if (random % 3 == 0) {
            DragPayload.New(fresh[random % fresh.size])
        } else {
            DragPayload.Value(values[random / 7 % values.size].span)
        }
        return BlockEvent.Dropped(load, if (random % 5 == 0) BlockTarget.Bin else to)
    }

    private fun OnBlocks.dragIntoBin(row: BlockRow?): BlockEvent {
        val run = row?.let { state.runOf(it.block.id) } ?: return BlockEvent.ErrorDismissed
        return BlockEvent.Dropped(DragPayload.Blocks(run), BlockTarget.Bin)
    }

    private fun OnBlocks.dragTo(row: BlockRow?): BlockEvent {
        val run = state.run ?: return BlockEvent.ErrorDismissed
        val place = row?.placeBelow(state.program) ?: return BlockEvent.ErrorDismissed
        return BlockEvent.Dropped(DragPayload.Blocks(run), BlockTarget.Between(place))
    }

    private companion object {
        const val KINDS = 17
        const val CHOICES = KINDS * 1_000
        val TEXTS = listOf("5", "-3", "2.5", "x", "left", "light", "1 + 2", "\"", "", "left bumper")
        val PASTED =
            listOf("7", "beep\nturn left 90", "what is this?", "repeat 2 times\nbeep", "  ", "else", "left bumper")
        const val PROGRAM = "var x = 3\nrepeat 4 times\n  forward x\n  // turn\n  turn left 90\nend\n\nforwrd 2\n" +
            "if light < 40\n  beep\nelse\nend\n"
    }
}
