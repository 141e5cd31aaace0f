package robotran.workshop.settings

import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.MemoryStore
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.PaneSizes
import robotran.workshop.state.Settings
import robotran.workshop.state.WindowForm
import robotran.workshop.state.WindowSizes
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class PaneSizesTest {
    private val machine = Machine()
    private val workshop: Workshop by lazy { machine.window() }

    @Test
    fun `each form of window has its own sizes, and the machine remembers them`() {
        workshop.handle(SettingsEvent.ProgramShareChosen(WindowForm.UPRIGHT, 0.6f))
        workshop.handle(SettingsEvent.ProgramShareChosen(WindowForm.ACROSS, 0.25f))
        workshop.handle(SettingsEvent.BrickSizeChosen(WindowForm.ACROSS, isWhole = true))
        runBlocking { workshop.closeDocument() }
        val again = machine.window().state.settings.panes
        assertEquals(PaneSizes(0.6f), again[WindowForm.UPRIGHT])
        assertEquals(PaneSizes(0.25f, isBrickWhole = true), again[WindowForm.ACROSS])
        assertEquals(PaneSizes(), again[WindowForm.BROAD])
    }

    @Test
    fun `the first size comes back, and the brick keeps its own`() {
        workshop.handle(SettingsEvent.BrickSizeChosen(WindowForm.UPRIGHT, isWhole = true))
        workshop.handle(SettingsEvent.ProgramShareChosen(WindowForm.UPRIGHT, 0.6f))
        workshop.handle(SettingsEvent.ProgramShareChosen(WindowForm.UPRIGHT, null))
        assertEquals(PaneSizes(null, isBrickWhole = true), workshop.state.settings.panes.upright)
    }

    @Test
    fun `settings from before there were sizes are read, and impossible sizes are not taken`() {
        assertEquals(Settings(textScale = 1.5f), read("""{"textScale":1.5}"""))
        assertEquals(
            Settings(panes = WindowSizes(upright = PaneSizes(isBrickWhole = false))),
            read("""{"panes":{"upright":{"programShare":7,"isBrickWhole":false},"across":{"programShare":-1}}}"""),
        )
        assertEquals(Settings(textScale = 1.5f), read("""{"textScale":1.5,"panes":{"watch":{"programShare":0.2}}}"""))
    }

    @Test
    fun `a pane that has all the room gives it back on the second touch, and when another has to be seen`() {
        workshop.handle(ScreenEvent.PaneFilled(Pane.PROGRAM))
        assertEquals(Pane.PROGRAM, workshop.state.fullPane)
        workshop.handle(RunEvent.RunPressed)
        assertNull(workshop.state.fullPane, "The robot that drives is not seen")
        workshop.handle(ScreenEvent.PaneFilled(Pane.WORLD))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
        assertEquals(Pane.WORLD, workshop.state.fullPane)
        workshop.handle(ProgramEvent.ProgramEdited("forwrd 20"))
        workshop.handle(RunEvent.RunPressed)
        assertNull(workshop.state.fullPane, "The mistake is not seen")
        workshop.handle(ScreenEvent.PaneFilled(Pane.WORLD))
        workshop.handle(ScreenEvent.PaneFilled(null))
        assertNull(workshop.state.fullPane)
    }

    private fun read(text: String): Settings = runBlocking {
        val store = MemoryStore()
        store.write("settings", text)
        SettingsStateHolder.readFrom(store)
    }
}
