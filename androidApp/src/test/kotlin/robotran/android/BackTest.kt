package robotran.android

import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import robotran.ui.program.tags.ProgramTags
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane

@RunWith(RobolectricTestRunner::class)
class BackTest {
    @get:Rule
    val app = TestedApp()

    @Before
    fun open() = app.open(Device.PHONE.qualifiers(upright = true))

    @Test
    fun `Back leaves the welcome, the settings and the drawer before it leaves the app`() {
        app.goBack()
        assertNull(app.workshop.state.learning.page)
        show(RunEvent.DrawerChosen(DrawerTab.LOG))
        show(SettingsEvent.SettingsShown(true))
        app.goBack()
        assertFalse(app.workshop.state.settingsShown)
        assertEquals(DrawerTab.LOG, app.workshop.state.run.drawer.tab)
        app.goBack()
        assertNull(app.workshop.state.run.drawer.tab)
        assertFalse(app.activity.isFinishing)
        app.goBack()
        assertTrue(app.activity.isFinishing)
    }

    @Test
    fun `Back goes from the other panes of a phone to the world`() {
        app.goBack()
        show(ScreenEvent.PaneChosen(Pane.BRICK))
        app.goBack()
        assertEquals(Pane.WORLD, app.workshop.state.pane)
        assertFalse(app.activity.isFinishing)
    }

    @Test
    fun `on a tablet all panes are there, so Back leaves the app once nothing lies over them`() {
        app.change(Device.TABLET_11_INCH.qualifiers(upright = false))
        app.goBack()
        show(ScreenEvent.PaneChosen(Pane.PROGRAM))
        show(RunEvent.DrawerChosen(DrawerTab.CHART))
        app.goBack()
        assertNull(app.workshop.state.run.drawer.tab)
        app.goBack()
        assertTrue(app.activity.isFinishing)
    }

    @Test
    fun `Back closes the find bar and leaves the program as it is`() {
        app.goBack()
        show(ScreenEvent.PaneChosen(Pane.PROGRAM))
        app.touch(ProgramTags.FIND_OPEN)
        assertTrue(app.isThere(ProgramTags.FIND_BAR))
        app.goBack()
        assertFalse(app.isThere(ProgramTags.FIND_BAR))
        assertEquals(Pane.PROGRAM, app.workshop.state.pane)
    }

    @Test
    fun `Back closes a page before the find bar that lies below it`() {
        app.goBack()
        show(ScreenEvent.PaneChosen(Pane.PROGRAM))
        app.touch(ProgramTags.FIND_OPEN)
        show(SettingsEvent.SettingsShown(true))
        app.goBack()
        assertFalse(app.workshop.state.settingsShown)
        assertTrue(app.isThere(ProgramTags.FIND_BAR))
        app.goBack()
        assertFalse(app.isThere(ProgramTags.FIND_BAR))
    }

    @Test
    fun `Back leaves the editor of worlds and keeps what was done`() {
        app.goBack()
        show(WorldEditEvent.EditorOpened)
        app.goBack()
        assertNull(app.workshop.state.worldEdit)
    }

    private fun show(event: WorkshopEvent) {
        app.workshop.handle(event)
        app.pass(300)
    }
}
