package robotran.ui.drawer

import androidx.compose.ui.test.ExperimentalTestApi
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.assertWhole
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.saysThereIsMore
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertFalse

@OptIn(ExperimentalTestApi::class)
class DrawerTabsTest {
    @Test
    fun `on a phone all names fit in English`() = onScreen(412, 915) { workshop ->
        workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        pass(300)
        for (tab in DrawerTab.entries) assertWhole(RunTags.tab(RunTags.DRAWER, tab), "in English")
        assertFalse(saysThereIsMore(RunTags.names(RunTags.DRAWER), isRight = true))
    }
}
