package robotran.ui.screen

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.state.Pane

/**
 * The tabs of the three panes of a narrow screen. [mistaken] marks the program's tab.
 *
 * @param chosen null while a lesson is in the place of all of them.
 */
@Composable
internal fun PaneTabs(chosen: Pane?, mistaken: Boolean, onChoose: (Pane) -> Unit, modifier: Modifier = Modifier) {
    val tabs = Pane.entries.map {
        Tab(it.title(spoken), ScreenTags.tab(it), isMarked = it == Pane.PROGRAM && mistaken)
    }
    Tabs(tabs, chosen?.ordinal, modifier) { onChoose(Pane.entries[it]) }
}

private val Pane.title: Label
    get() = when (this) {
        Pane.PROGRAM -> ScreenTexts::tabProgram
        Pane.WORLD -> ScreenTexts::tabWorld
        Pane.BRICK -> ScreenTexts::tabBrick
    }
