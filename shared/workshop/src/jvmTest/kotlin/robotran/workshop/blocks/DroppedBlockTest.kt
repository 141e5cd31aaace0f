package robotran.workshop.blocks

import robotran.projects.ProgramView
import robotran.robolang.RobolangProgram
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.programs.ProgramsStateHolder
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.RoomEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** The way of a block that is dropped: one event, and one reading of the program, which its blocks and the compiler share. */
class DroppedBlockTest {
    private fun OnBlocks.programs() = ProgramsStateHolder(workshop.project, workshop.services)

    private fun OnBlocks.isReadOnce(programs: ProgramsStateHolder): Boolean {
        val text = programs.state.blocks?.program?.outline?.parsed
        val program = programs.loads(workshop.state.world, listOf(0)).first().programs.first()
        return assertIs<RobolangProgram>(program).isMadeOf(checkNotNull(text))
    }

    @Test
    fun `what is compiled after a drop is what the blocks have read`() = onBlocks("beep\nrepeat 4 times\nend\n") {
        val programs = programs()
        val load = DragPayload.Blocks(state.runOf(block("beep")))
        val inside = checkNotNull(state.program.endOf(block("repeat 4 times")))
        programs.handle(BlockEvent.Dropped(load, BlockTarget.Between(inside)))
        assertEquals("repeat 4 times\n  beep\nend\n", programs.state.draft.text)
        assertTrue(isReadOnce(programs))
        programs.handle(ProgramEvent.Undone)
        assertTrue(isReadOnce(programs))
    }

    @Test
    fun `others hear once of a block that is dropped`() = onBlocks("beep\nrepeat 4 times\nend\n") {
        val heard = mutableListOf<RoomEvent>()
        workshop.services.events.subscribe { heard += it }
        val inside = checkNotNull(state.program.endOf(block("repeat 4 times")))
        drag(DragPayload.Blocks(state.runOf(block("beep"))), BlockTarget.Between(inside))
        assertEquals(1, heard.count { it is ProgramRoomEvent })
        assertEquals(ProgramRoomEvent.Written(byUser = true), heard.single { it is ProgramRoomEvent })
    }

    @Test
    fun `text that is typed beside blocks is read once, too`() = onBlocks("beep\n") {
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        val programs = programs()
        programs.handle(ProgramEvent.ProgramEdited("beep\nforward 20\n"))
        assertTrue(isReadOnce(programs))
    }
}
