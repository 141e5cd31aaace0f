package robotran.workshop.worldedit

import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Notice
import robotran.world.PortSensor
import robotran.world.file.BuiltInWorlds
import robotran.worldediting.Edit
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A sensor that a program lacks is plugged in by changing the world. */
class PlugInTest {
    private val workshop = runBlocking { openWorkshop() }

    @AfterTest
    fun close() = workshop.close()

    private val Workshop.ports get() = project.world.robots.first().ports

    /** Runs a program that feels with both bumpers in a world whose robot has only the right one. */
    private fun runWithoutLeftBumper() {
        val robots = BuiltInWorlds.plain.robots.map {
            it.copy(ports = listOf(emptyList(), listOf(PortSensor.LIGHT), listOf(PortSensor.RIGHT_BUMPER)))
        }
        workshop.changeWorld(BuiltInWorlds.plain.copy(robots = robots))
        workshop.handle(ProgramEvent.ProgramEdited("if left bumper\n  beep\nend\nwait 5 seconds\n"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(300)
    }

    private fun plugIn() {
        val missing = workshop.state.shownProgramRun.missingSensors.single()
        workshop.handle(WorldEditEvent.SensorPluggedIn(workshop.state.shownProgramRun.robot, missing))
    }

    @Test
    fun `a program that expects a bumper where none is says so once, at the top of all remarks`() {
        runWithoutLeftBumper()
        val run = workshop.state.shownProgramRun
        assertEquals(listOf(1), run.missingSensors.map { it.port })
        assertContains(run.remarks.first().message, "touch sensor on port 1")
        assertEquals(1, workshop.state.run.marks.count { it.text.contains("touch sensor") })
    }

    @Test
    fun `what is plugged in is in the world, and the next run has it`() {
        runWithoutLeftBumper()
        plugIn()
        val expected = listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.LIGHT), listOf(PortSensor.RIGHT_BUMPER))
        assertEquals(expected, workshop.ports)
        assertEquals(Notice.SensorPluggedIn(1), workshop.state.notice)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(300)
        assertTrue(workshop.state.running)
        assertEquals(emptyList(), workshop.state.shownProgramRun.remarks)
    }

    @Test
    fun `the notice undoes it`() {
        runWithoutLeftBumper()
        plugIn()
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(emptyList(), workshop.ports.first())
        assertNull(workshop.state.notice)
    }

    @Test
    fun `the world editor undoes it, and then the notice does nothing more`() {
        runWithoutLeftBumper()
        plugIn()
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(Edit.Undo))
        workshop.handle(WorldEditEvent.EditorClosed)
        assertEquals(emptyList(), workshop.ports.first())
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(emptyList(), workshop.ports.first())
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(Edit.Redo))
        workshop.handle(WorldEditEvent.EditorClosed)
        assertEquals(listOf(PortSensor.LEFT_BUMPER), workshop.ports.first())
    }

    @Test
    fun `nothing is plugged in while the world is being edited`() {
        runWithoutLeftBumper()
        val missing = workshop.state.shownProgramRun.missingSensors.single()
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.SensorPluggedIn(0, missing))
        assertEquals(emptyList(), workshop.ports.first())
        assertNull(workshop.state.notice)
    }
}
