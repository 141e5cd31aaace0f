package robotran.workshop.run

import androidx.compose.runtime.State
import androidx.compose.runtime.snapshots.Snapshot
import kotlinx.coroutines.runBlocking
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.state.RunPaneState
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** The way of Run: one new run, one state of it, and each room hears of it once. */
class RunPressedTest {
    private val workshop = runBlocking { openWorkshop() }
    private val heard = mutableListOf<RoomEvent>()

    @AfterTest
    fun close() = workshop.close()

    /** How many states of the run [act] publishes. */
    private fun statesOf(act: () -> Unit): Int {
        var states = 0
        val count = { changed: Any -> if ((changed as? State<*>)?.value is RunPaneState) states++ }
        Snapshot.observe(writeObserver = count, block = act)
        return states
    }

    @Test
    fun `Run makes one state of one run`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 20\n"))
        workshop.services.events.subscribe { heard += it }
        assertEquals(1, statesOf { workshop.handle(RunEvent.RunPressed) })
        assertEquals(RunRoomEvent.Pressed, heard[0])
        assertEquals(RunRoomEvent.Started(byUser = true), heard[1])
        assertIs<RunRoomEvent.Changed>(heard[2])
        assertEquals(listOf(ProjectRoomEvent.Touched), heard.drop(3))
    }

    @Test
    fun `a program that is not compiled is compiled once and starts then`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 20\n" + "beep\n".repeat(3_000)))
        workshop.handle(RunEvent.RunPressed)
        assertFalse(workshop.state.run.running)
        workshop.services.events.subscribe { heard += it }
        assertEquals(1, statesOf { runBlocking { workshop.compilePrograms() } })
        assertEquals(1, heard.count { it is ProgramRoomEvent.Compiled })
        workshop.advance(100)
        assertTrue(workshop.state.run.running)
        assertFalse(workshop.state.run.untouched)
    }
}
