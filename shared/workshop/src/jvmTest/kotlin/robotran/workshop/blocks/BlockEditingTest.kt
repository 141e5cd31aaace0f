package robotran.workshop.blocks

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditError
import robotran.language.ProgramLanguage
import robotran.projects.ProgramView
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertNull

class BlockEditingTest {
    @Test
    fun `blocks from the palette go below the cursor, into a block and out of it again`() = onBlocks("") {
        take("repeat")
        take("move")
        take("turn")
        goTo("end")
        take("beep")
        assertEquals("repeat 4 times\n  forward 20\n  turn left 90\nend\nbeep", text.trim())
        assertEquals("beep", row)
    }

    @Test
    fun `an own command goes outside of all blocks from any cursor`() = onBlocks("repeat 2 times\n  beep\nend\n") {
        goTo("beep")
        take("procedure")
        assertEquals("repeat 2 times\n  beep\nend\nprocedure trick()\nend", text.trim())
    }

    @Test
    fun `undo brings back the text and the same blocks`() = onBlocks("forward 20\nbeep\n") {
        val beep = block("beep")
        edit(BlockEdit.Delete(setOf(beep)))
        assertEquals("forward 20\n", text)
        send(ProgramEvent.Undone)
        assertEquals("forward 20\nbeep\n", text)
        assertEquals(text, state.program.text)
        send(ProgramEvent.Redone)
        assertEquals("forward 20\n", text)
        assertEquals(text, state.program.text)
    }

    @Test
    fun `undo and redo say what they have changed, each time anew`() = onBlocks("beep\n") {
        goTo("beep")
        repeat(2) { edit(BlockEdit.Duplicate(checkNotNull(state.run))) }
        send(ProgramEvent.Undone)
        val first = state.said
        assertEquals("Undone. Gone: beep", first)
        send(ProgramEvent.Undone)
        assertEquals(first, state.said?.trim())
        assertNotEquals(first, state.said)
        send(ProgramEvent.Redone)
        assertEquals("Redone. Now: beep, 2 of 2", state.said)
        send(ProgramEvent.DraftChanged(TextDocument("beep\nbuzz\n"), EditKind.OTHER))
        assertNull(state.said)
    }

    @Test
    fun `undo of text that is typed beside the blocks says what is different in them`() = onBlocks("beep\n") {
        send(BlockEvent.ViewChosen(ProgramView.BOTH))
        write("beep\nforward 5\n")
        send(ProgramEvent.Undone)
        assertEquals("Undone. Gone: forward 5 cm", state.said)
        send(BlockEvent.ViewChosen(ProgramView.TEXT))
        send(ProgramEvent.Redone)
        assertEquals("beep\nforward 5\n", text)
    }

    @Test
    fun `all that is done in the sheet of a number is undone at once`() = onBlocks("forward 20\n") {
        open("forward 20", "20")
        for (number in listOf("2", "25", "250")) send(BlockEvent.Put(number))
        assertEquals("forward 250\n", text)
        assertEquals("250", (state.sheet as BlockDialog.Part).span.textIn(text))
        send(BlockEvent.DialogShown(null))
        send(ProgramEvent.Undone)
        assertEquals("forward 20\n", text)
    }

    @Test
    fun `what was done before a sheet was opened is undone separately`() = onBlocks("forward 20\n") {
        open("forward 20", "20")
        send(BlockEvent.Put("30"))
        open("forward 30", "30")
        send(BlockEvent.Put("40"))
        send(ProgramEvent.Undone)
        assertEquals("forward 30\n", text)
    }

    @Test
    fun `an impossible edit leaves the program alone and says why`() = onBlocks("repeat 4 times\nend\n") {
        open("repeat 4 times", "4")
        send(BlockEvent.Put("left bumper"))
        assertEquals("repeat 4 times\nend\n", text)
        assertEquals(BlockEditError.NumberNeeded, state.error)
        send(BlockEvent.ErrorDismissed)
        assertNull(state.error)
    }

    @Test
    fun `a breakpoint moves with its block`() = onBlocks("forward 20\nbeep\nturn left 90\n") {
        send(ProgramEvent.BreakpointToggled(2))
        goTo("beep")
        send(BlockEvent.Moved(isUp = true))
        assertEquals("beep\nforward 20\nturn left 90\n", text)
        assertEquals(setOf(1), workshop.state.programs.breakpoints)
    }

    @Test
    fun `a block that is carried lands where it was last`() = onBlocks("beep\nrepeat 4 times\nend\n") {
        val load = DragPayload.Blocks(state.runOf(block("beep")))
        val inside = checkNotNull(state.program.endOf(block("repeat 4 times")))
        drag(load, BlockTarget.Between(inside))
        assertEquals("repeat 4 times\n  beep\nend\n", text)
    }

    @Test
    fun `a block that lands where only values go stays where it was`() = onBlocks("beep\nforward 20\n") {
        drag(DragPayload.Blocks(state.runOf(block("beep"))), BlockTarget.Socket(span("forward 20", "20")))
        assertEquals("beep\nforward 20\n", text)
    }

    @Test
    fun `typed text becomes blocks, and an open sheet of a part closes`() = onBlocks("forward 20\n") {
        open("forward 20", "20")
        write("forward 20\nbeep\n")
        assertEquals(2, state.list.rows.size)
        assertEquals("forward 20", row)
        assertNull(state.sheet)
    }

    @Test
    fun `a mistake that keeps the program from running is where the keyboard goes`() = onBlocks("beep\nforwrd 20\n") {
        workshop.handle(RunEvent.RunPressed)
        assertEquals("forwrd 20", row)
    }

    @Test
    fun `beside the text, the row is that of the caret, also after undo`() = onBlocks("beep\nbuzz\nstop\n") {
        send(BlockEvent.ViewChosen(ProgramView.BOTH))
        send(ProgramEvent.DraftChanged(TextDocument(text).withCaret(text.indexOf("uzz")), EditKind.OTHER))
        assertEquals("buzz", row)
        send(ProgramEvent.DraftChanged(TextDocument("beep\nbuzz\nhalt\n").withCaret(12), EditKind.OTHER))
        assertEquals("halt", row)
        goTo("beep")
        send(ProgramEvent.Undone)
        assertEquals("beep\nbuzz\nstop\n", text)
        assertEquals("buzz", row)
    }

    @Test
    fun `each program remembers how it is shown`() = onBlocks("beep\n") {
        send(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG))
        assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
        send(BlockEvent.ViewChosen(ProgramView.TEXT))
        send(ProgramEvent.ProgramChosen(0))
        assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
        assertEquals("beep\n", state.program.text)
    }

    @Test
    fun `a project that is opened later is shown as the pupil chose last`() = onBlocks("beep\n") {
        workshop.services.editor.openProject(workshop.project)
        assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
        assertEquals("beep\n", state.program.text)
    }

    @Test
    fun `blocks do not change a program that is shown as text`() = onBlocks("beep\n") {
        send(BlockEvent.ViewChosen(ProgramView.TEXT))
        take("move")
        assertEquals("beep\n", text)
    }

    @Test
    fun `a Java program stays text`() = onBlocks("beep\n") {
        send(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        send(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        assertEquals(ProgramView.TEXT, workshop.state.programs.view)
    }

    @Test
    fun `a folded block hides what is inside and stays folded while the program changes`() =
        onBlocks("repeat 4 times\n  beep\nend\nbuzz\n") {
            send(BlockEvent.Folded(block("repeat 4 times")))
            assertEquals(2, state.list.rows.size)
            goTo("buzz")
            take("stop")
            assertEquals(3, state.list.rows.size)
            assertIs<BlockCursor.At>(state.cursor)
        }
}
