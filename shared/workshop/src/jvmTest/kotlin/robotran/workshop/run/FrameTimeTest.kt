package robotran.workshop.run

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.WorkshopStatus
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class FrameTimeTest {
    private val workshop = runBlocking { openWorkshop() }
    private var now = 5_000_000_000L

    @AfterTest
    fun close() = workshop.close()

    @Test
    fun `virtual time follows the frames without losing their fractions`() {
        workshop.handle(RunEvent.RunPressed)
        val before = workshop.state.session.milliseconds
        frames(count = 61, nanoseconds = 16_666_667)
        assertEquals(1000, workshop.state.session.milliseconds - before)
    }

    @Test
    fun `a machine that is too slow shows slow motion instead of falling behind`() {
        workshop.handle(RunEvent.RunPressed)
        val before = workshop.state.session.milliseconds
        frames(count = 11, nanoseconds = 3_000_000_000)
        assertEquals(1000, workshop.state.session.milliseconds - before)
    }

    @Test
    fun `a clock that jumps back does no harm`() {
        workshop.handle(RunEvent.RunPressed)
        frames(count = 2, nanoseconds = 20_000_000)
        val before = workshop.state.session.milliseconds
        frames(count = 1, nanoseconds = -1_000_000_000)
        assertEquals(before, workshop.state.session.milliseconds)
    }

    @Test
    fun `time rests when nothing moves and goes on when somebody presses a button`() {
        frames(count = 100, nanoseconds = 16_666_667)
        assertFalse(workshop.state.awake)
        val rested = workshop.state.session.milliseconds
        frames(count = 100, nanoseconds = 16_666_667)
        assertEquals(rested, workshop.state.session.milliseconds)
        workshop.handle(RunEvent.ButtonPressed(BrickButton.PRGM))
        assertTrue(workshop.state.awake)
    }

    @Test
    fun `time rests after the program has ended`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 1\nbeep"))
        workshop.handle(RunEvent.RunPressed)
        frames(count = 200, nanoseconds = 16_666_667)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertFalse(workshop.state.awake)
    }

    @Test
    fun `time goes on while a program waits`() {
        workshop.handle(ProgramEvent.ProgramEdited("wait 60 seconds"))
        workshop.handle(RunEvent.RunPressed)
        frames(count = 200, nanoseconds = 16_666_667)
        assertTrue(workshop.state.awake)
    }

    private fun frames(count: Int, nanoseconds: Long) = repeat(count) {
        now += nanoseconds
        workshop.frame(now)
    }
}
