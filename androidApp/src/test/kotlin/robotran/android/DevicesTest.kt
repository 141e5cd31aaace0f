package robotran.android

import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.performTouchInput
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.ParameterizedRobolectricTestRunner
import org.robolectric.ParameterizedRobolectricTestRunner.Parameters
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopStatus

/** A long session with the app, on every kind of device in both orientations. */
@RunWith(ParameterizedRobolectricTestRunner::class)
class DevicesTest(
    @Suppress("unused") private val name: String,
    private val device: Device,
    private val upright: Boolean,
) {
    @get:Rule
    val app = TestedApp()

    private val picture = device.pictureName(upright)

    @Test
    fun `a pupil writes, runs, stops, looks back, changes the world, turns the tablet, and finds all again`() {
        app.open(device.qualifiers(upright))
        app.photograph("$picture-1-first")
        app.leaveFirstPage()
        write()
        run()
        lookBack()
        changeTheWorld()
        turn()
        comeBack()
    }

    private fun write() {
        show(Pane.PROGRAM)
        app.screen.onNodeWithTag(ProgramTags.PROGRAM).performTextReplacement(PROGRAM)
        app.pass(SHORT)
        app.photograph("$picture-2-write")
        assertEquals(PROGRAM, app.workshop.state.programText)
    }

    private fun run() {
        show(Pane.WORLD)
        app.touch(RunTags.RUN)
        app.pass(LONG)
        app.photograph("$picture-3-run")
        assertTrue(app.workshop.state.running)
        assertTrue(app.activity.window.decorView.isKeptOn())
        app.touch(RunTags.STOP)
        assertEquals(WorkshopStatus.Ended(stopped = true), app.workshop.state.status)
        assertTrue(!app.activity.window.decorView.isKeptOn())
    }

    private fun lookBack() {
        val length = app.workshop.state.run.length
        app.screen.onNodeWithTag(RunTags.TIMELINE).performTouchInput { down(center) }
        app.pass(SHORT)
        app.screen.onNodeWithTag(RunTags.TIMELINE).performTouchInput { up() }
        app.pass(SHORT)
        app.photograph("$picture-4-look-back")
        assertTrue(app.workshop.state.run.time in length / 4..length * 3 / 4)
    }

    private fun changeTheWorld() {
        app.workshop.handle(WorldEditEvent.EditorOpened)
        app.pass(SHORT)
        app.photograph("$picture-5-world")
        app.screen.onNodeWithTag(WorldTags.done(WorldTags.EDIT)).assertIsDisplayed()
        app.touch(WorldTags.done(WorldTags.EDIT))
        assertNull(app.workshop.state.worldEdit)
    }

    private fun turn() {
        show(Pane.PROGRAM)
        val before = app.activity
        app.change(device.qualifiers(!upright))
        app.photograph("$picture-6-turned")
        assertEquals("nothing is made anew by a turn", before, app.activity)
        app.screen.onNodeWithTag(ProgramTags.PROGRAM).assertIsDisplayed()
        app.change(device.qualifiers(upright))
    }

    private fun comeBack() {
        show(Pane.WORLD)
        app.touch(RunTags.RUN)
        app.pass(LONG)
        val before = app.workshop.state
        app.simulateProcessDeath()
        app.pass(LONG)
        app.photograph("$picture-7-back")
        assertEquals(PROGRAM, app.workshop.state.programText)
        assertEquals(Pane.WORLD, app.workshop.state.pane)
        assertEquals(before.run.time, app.workshop.state.run.time)
        assertEquals(before.session.ink.lengthCentimetres, app.workshop.state.session.ink.lengthCentimetres, 0.0)
    }

    private fun show(pane: Pane) {
        app.workshop.handle(ScreenEvent.PaneChosen(pane))
        app.pass(SHORT)
    }

    companion object {
        private const val PROGRAM = "pen down\nrepeat 6 times\n  forward 15\n  turn right 60\nend\n"

        /** Milliseconds. */
        private const val SHORT = 300L
        private const val LONG = 4_000L

        @JvmStatic
        @Parameters(name = "{0}")
        fun devices(): List<Array<Any>> =
            Device.entries.flatMap { device -> listOf(true, false).map { arrayOf(device.pictureName(it), device, it) } }
    }
}
