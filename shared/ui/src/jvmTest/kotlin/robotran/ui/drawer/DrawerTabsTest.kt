package robotran.ui.drawer

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import robotran.language.Language
import robotran.ui.screen.assertWhole
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.saysThereIsMore
import robotran.ui.screen.scroll
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class DrawerTabsTest {
    @Test
    fun `on a phone all names fit in English`() = onScreen(412, 915) { workshop ->
        workshop.handle(WorkshopEvent.PaneChosen(Pane.WORLD))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        pass(300)
        for (tab in DrawerTab.entries) assertWhole("drawer-${tab.name.lowercase()}", "in English")
        assertFalse(saysThereIsMore("drawer-names", isRight = true))
    }

    @Test
    fun `the name of what is shown is in sight, and where not all fit it is seen that there are more`() {
        for ((width, height) in listOf(412 to 915, 360 to 740, 820 to 1180)) {
            for (scale in listOf(1f, 2f)) {
                for (language in Language.entries) {
                    onScreen(width, height) { workshop ->
                        val told = "$width x $height at $scale in $language"
                        workshop.handle(
                            SettingsEvent.SettingsChanged(
                                Settings(language = language, textScale = scale, lessMotion = true),
                            ),
                        )
                        workshop.handle(WorkshopEvent.PaneChosen(Pane.WORLD))
                        for (tab in DrawerTab.entries.reversed()) {
                            workshop.handle(RunEvent.DrawerChosen(tab))
                            pass(600)
                            assertWhole("drawer-${tab.name.lowercase()}", told)
                        }
                        val last = onNodeWithTag("drawer-why").fetchSemanticsNode()
                        val isCut = last.boundsInRoot.width < last.size.width - 0.5f
                        if (isCut) {
                            assertTrue(
                                saysThereIsMore("drawer-names", isRight = true),
                                "$told: nothing says that there are more",
                            )
                        }
                        scroll("drawer-names", toEnd = true)
                        assertFalse(saysThereIsMore("drawer-names", isRight = true), told)
                    }
                }
            }
        }
    }
}
