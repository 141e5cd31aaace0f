package robotran.workshop.run

import robotran.brick.controls.BrickButton
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class LoneEscapeTest {
    private val escape = LoneEscape()

    private fun tap(isRunning: Boolean = true, isRunningAfter: Boolean = isRunning): Boolean {
        escape.pressed(BrickButton.ESCAPE, isRunning)
        return escape.released(BrickButton.ESCAPE, isRunningAfter)
    }

    @Test
    fun `ESCAPE alone is told once per run`() {
        assertTrue(tap())
        assertFalse(tap())
        escape.forget()
        assertTrue(tap())
    }

    @Test
    fun `nothing is told while no program runs, or if it ends then`() {
        assertFalse(tap(isRunning = false))
        assertFalse(tap(isRunningAfter = false))
    }

    @Test
    fun `ENTER with it is not ESCAPE alone, whichever comes first`() {
        escape.pressed(BrickButton.ENTER, isRunning = true)
        assertFalse(tap())
        escape.released(BrickButton.ENTER, isRunning = true)
        escape.pressed(BrickButton.ESCAPE, isRunning = true)
        escape.pressed(BrickButton.ENTER, isRunning = true)
        escape.released(BrickButton.ENTER, isRunning = true)
        assertFalse(escape.released(BrickButton.ESCAPE, isRunning = true))
    }
}
