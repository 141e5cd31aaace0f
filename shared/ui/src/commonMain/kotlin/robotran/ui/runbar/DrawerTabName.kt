package robotran.ui.runbar

import org.jetbrains.compose.resources.StringResource
import robotran.ui.resources.Res
import robotran.ui.resources.run_tab_chart
import robotran.ui.resources.run_tab_goals
import robotran.ui.resources.run_tab_log
import robotran.ui.resources.run_tab_variables
import robotran.ui.resources.run_tab_why
import robotran.workshop.state.DrawerTab

/** The name of the tab. */
internal val DrawerTab.word: StringResource
    get() = when (this) {
        DrawerTab.VARIABLES -> Res.string.run_tab_variables
        DrawerTab.LOG -> Res.string.run_tab_log
        DrawerTab.CHART -> Res.string.run_tab_chart
        DrawerTab.GOALS -> Res.string.run_tab_goals
        DrawerTab.WHY -> Res.string.run_tab_why
    }
