package robotran.android

import androidx.lifecycle.SavedStateHandle
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopEvent

@RunWith(RobolectricTestRunner::class)
class KeptWorkshopTest {
    @Test
    fun `the program text comes back after Android has ended the process`() {
        val first = SavedStateHandle()
        opened(first).handle(WorkshopEvent.ProgramEdited("forward 7"))
        assertEquals("forward 7", opened(broughtBack(first)).state.programText)
    }

    @Test
    fun `a text too long for the saved state gives way to the first program`() {
        val first = SavedStateHandle()
        val firstText = opened(first).state.programText
        opened(first).handle(WorkshopEvent.ProgramEdited("beep\n".repeat(100_000)))
        assertEquals(firstText, opened(broughtBack(first)).state.programText)
    }

    @Test
    fun `sound that was switched off stays off after Android has ended the process`() {
        val first = SavedStateHandle()
        opened(first).handle(WorkshopEvent.SoundSwitched(on = false))
        assertFalse(opened(broughtBack(first)).state.soundOn)
    }

    private fun opened(savedState: SavedStateHandle): Workshop = checkNotNull(KeptWorkshop(savedState).workshop)

    private fun broughtBack(savedState: SavedStateHandle): SavedStateHandle =
        SavedStateHandle.createHandle(savedState.savedStateProvider().saveState(), null)
}
