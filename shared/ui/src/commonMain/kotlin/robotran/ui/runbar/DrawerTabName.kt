package robotran.ui.runbar

import androidx.compose.runtime.Composable
import androidx.compose.runtime.compositionLocalOf
import org.jetbrains.compose.resources.StringResource
import robotran.brick.kind.BrickKind
import robotran.ui.resources.*
import robotran.workshop.state.DrawerTab

/** The kind of brick of the watched robot. */
internal val LocalBrickKind = compositionLocalOf { BrickKind.RCX }

/** The name of the tab. */
internal val DrawerTab.word: StringResource
    @Composable get() = when (this) {
        DrawerTab.VARIABLES -> Res.string.run_tab_variables

        DrawerTab.LOG -> if (LocalBrickKind.current == BrickKind.RCX) {
            Res.string.run_tab_log
        } else {
            Res.string.run_tab_calls
        }

        DrawerTab.CHART -> Res.string.run_tab_chart
        DrawerTab.GOALS -> Res.string.run_tab_goals
        DrawerTab.WHY -> Res.string.run_tab_why
    }
