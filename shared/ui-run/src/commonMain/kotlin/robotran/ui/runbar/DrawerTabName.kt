package robotran.ui.runbar

import androidx.compose.runtime.Composable
import androidx.compose.runtime.compositionLocalOf
import robotran.brick.kind.BrickKind
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.BrickLabels
import robotran.uikit.*
import robotran.workshop.state.DrawerTab

/** The kind of brick of the watched robot. */
val LocalBrickKind = compositionLocalOf<BrickKind> { error("No robot is watched.") }

/** The name of the tab. */
internal val DrawerTab.word: Label
    @Composable get() = when (this) {
        DrawerTab.VARIABLES -> RunTexts::tabVariables
        DrawerTab.LOG -> BrickLabels.of(LocalBrickKind.current).log
        DrawerTab.CHART -> RunTexts::tabChart
        DrawerTab.GOALS -> RunTexts::tabGoals
        DrawerTab.WHY -> RunTexts::tabWhy
    }
