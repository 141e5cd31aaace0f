package robotran.android

import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.ParameterizedRobolectricTestRunner
import org.robolectric.ParameterizedRobolectricTestRunner.Parameters
import robotran.ui.run.tags.RunTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Pane

/**
 * The dark theme and double font size on every kind of device in both orientations: takes screenshots for review and
 * checks that Run is reachable.
 */
@RunWith(ParameterizedRobolectricTestRunner::class)
class LooksTest(
    @Suppress("unused") private val name: String,
    private val device: Device,
    private val upright: Boolean,
    private val dark: Boolean,
) {
    @get:Rule
    val app = TestedApp()

    @Test
    fun `program, run, world editor and settings can be seen`() {
        val picture = "${device.pictureName(upright)}-${if (dark) "dark" else "large"}"
        app.open(device.qualifiers(upright, dark), fontScale = if (dark) 1f else 2f)
        app.leaveFirstPage()
        show(ScreenEvent.PaneChosen(Pane.PROGRAM))
        app.screen.onNodeWithTag(RunTags.RUN).assertIsDisplayed()
        app.photograph("$picture-1-program")
        show(ScreenEvent.PaneChosen(Pane.WORLD))
        app.touch(RunTags.RUN)
        app.pass(RUN)
        app.screen.onNodeWithTag(RunTags.STOP).assertIsDisplayed()
        app.photograph("$picture-2-run")
        show(WorldEditEvent.EditorOpened)
        app.screen.onNodeWithTag(WorldTags.done(WorldTags.EDIT)).assertIsDisplayed()
        app.photograph("$picture-3-world")
        show(WorldEditEvent.EditorClosed)
        show(SettingsEvent.SettingsShown(true))
        app.photograph("$picture-4-settings")
    }

    private fun show(event: WorkshopEvent) {
        app.workshop.handle(event)
        app.pass(SHORT)
    }

    companion object {
        /** Milliseconds. */
        private const val SHORT = 300L
        private const val RUN = 3_000L

        @JvmStatic
        @Parameters(name = "{0}, dark {3}")
        fun looks(): List<Array<Any>> = listOf(true, false).flatMap { dark ->
            Device.entries.flatMap { device ->
                listOf(true, false).map { arrayOf(device.pictureName(it), device, it, dark) }
            }
        }
    }
}
