package robotran.workshop

import io.kotest.property.Arb
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.language.ProgramLanguage
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class WorkshopPropertyTest {
    /** Random user actions in any order; time passes after each. */
    private val events: Arb<WorkshopEvent> = Arb.choice(
        Arb.constant(RunEvent.RunPressed),
        Arb.constant(RunEvent.StopPressed),
        Arb.enum<BrickButton>().map(RunEvent::ButtonPressed),
        Arb.enum<BrickButton>().map(RunEvent::ButtonReleased),
        Arb.enum<Pane>().map(ScreenEvent::PaneChosen),
        Arb.element("pen down\nforward 5", "forwrd 3", "repeat 3 times\n beep\nend", "", "wait 9 seconds")
            .map(ProgramEvent::ProgramEdited),
        Arb.string(0..30).map(ProgramEvent::ProgramEdited),
        Arb.enum<ProgramLanguage>().map(ProgramEvent::NewProgramRequested),
        Arb.int(-1..5).map(ProgramEvent::ProgramChosen),
        Arb.int(-1..5).map(ProgramEvent::FileChosen),
        Arb.int(-1..5).map(ProgramEvent::ProgramClosed),
        Arb.constant(ProgramEvent.FileAdded),
        Arb.constant(ProgramEvent.ProgramReopened),
    )

    @Test
    fun `whatever somebody does, Stop stops it and Run in the run bar begins afresh`() = runBlocking<Unit> {
        checkAll(100, Arb.list(events, 0..25), Arb.int(0..700)) { done, milliseconds ->
            val workshop = openWorkshop()
            for (event in done) {
                workshop.handle(event)
                workshop.advance(milliseconds)
            }
            workshop.handle(RunEvent.StopPressed)
            assertFalse(workshop.state.running)
            workshop.handle(ProgramEvent.ProgramClosed(0))
            workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG))
            workshop.handle(ProgramEvent.ProgramEdited("pen down\nforward 5"))
            workshop.handle(RunEvent.RunPressed)
            assertTrue(workshop.state.running)
            assertEquals(workshop.state.world.start, workshop.state.session.robot.pose)
            workshop.close()
        }
    }

    @Test
    fun `applying every fix that is offered never fails`() = runBlocking<Unit> {
        val words =
            Arb.element(
                "forwrd",
                "forward",
                "20",
                "turn",
                "left",
                "repaet",
                "times",
                "end",
                "pen",
                "3,5",
                "\n",
                " ",
                "\r\n",
                "wait",
            )
        checkAll(300, Arb.list(words, 0..20).map { it.joinToString(" ") }) { text ->
            val workshop = openWorkshop()
            workshop.handle(ProgramEvent.ProgramEdited(text))
            for (diagnostic in workshop.state.diagnostics) workshop.handle(ProgramEvent.FixApplied(diagnostic))
            workshop.close()
        }
    }
}
