package robotran.android

import androidx.lifecycle.SavedStateHandle
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import robotran.ui.workshop.ProgramEvent
import robotran.ui.workshop.ProgramLanguage
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopStatus

@RunWith(RobolectricTestRunner::class)
class KeptWorkshopTest {
    @Test
    fun `the program text comes back after Android has ended the process`() {
        val first = SavedStateHandle()
        opened(first).handle(ProgramEvent.ProgramEdited("forward 7"))
        assertEquals("forward 7", opened(broughtBack(first)).state.programText)
    }

    @Test
    fun `all programs come back with all their files`() {
        val first = SavedStateHandle()
        val workshop = opened(first)
        workshop.handle(ProgramEvent.ProgramBegun(ProgramLanguage.JAVA))
        workshop.handle(ProgramEvent.ClassAdded)
        assertEquals(workshop.state.programs.programs, opened(broughtBack(first)).state.programs.programs)
    }

    @Test
    fun `a Java program is compiled and drives`() = runBlocking {
        val workshop = opened(SavedStateHandle())
        workshop.handle(ProgramEvent.ProgramBegun(ProgramLanguage.JAVA))
        workshop.readPrograms()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(3_000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertTrue(workshop.state.session.robot.pose.x > workshop.state.world.start.x + 30)
    }

    @Test
    fun `a text too long for the saved state gives way to the first program`() {
        val first = SavedStateHandle()
        val firstText = opened(first).state.programText
        opened(first).handle(ProgramEvent.ProgramEdited("beep\n".repeat(100_000)))
        assertEquals(firstText, opened(broughtBack(first)).state.programText)
    }

    @Test
    fun `sound that was switched off stays off after Android has ended the process`() {
        val first = SavedStateHandle()
        opened(first).handle(SettingsEvent.SoundSwitched(on = false))
        assertFalse(opened(broughtBack(first)).state.soundOn)
    }

    private fun opened(savedState: SavedStateHandle): Workshop = checkNotNull(KeptWorkshop(savedState).workshop)

    private fun broughtBack(savedState: SavedStateHandle): SavedStateHandle =
        SavedStateHandle.createHandle(savedState.savedStateProvider().saveState(), null)
}
