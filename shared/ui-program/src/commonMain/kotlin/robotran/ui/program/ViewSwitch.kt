package robotran.ui.program

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.dp
import robotran.projects.ProgramView
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/** Chooses between blocks, text, and both. It shows what the program is shown as now. */
@Composable
internal fun ViewSwitch(view: ProgramView, onView: (ProgramView) -> Unit) {
    var isOpen by remember { mutableStateOf(false) }
    Box {
        PaneChip(
            wordFor(view)(spoken),
            ProgramTags.VIEW_SWITCH,
            on = view != ProgramView.TEXT,
            others = VIEW_WORDS.map { it(spoken) },
            picture = { IconView(ThinIcons.DOWN, LocalRobotranColours.current.onPane, size = SIGN) },
        ) { isOpen = true }
        AppMenu(isOpen, { isOpen = false }) {
            for (choice in listOf(ProgramView.BLOCKS, ProgramView.TEXT, ProgramView.BOTH)) {
                MenuItem(wordFor(choice)(spoken), ProgramTags.view(choice)) {
                    isOpen = false
                    onView(choice)
                }
            }
        }
    }
}

private fun wordFor(view: ProgramView): Label = when (view) {
    ProgramView.TEXT -> CommonTexts::viewText
    ProgramView.BLOCKS -> CommonTexts::viewBlocks
    ProgramView.BOTH -> BlockTexts::viewBoth
}

private val SIGN = 12.dp

internal val VIEW_WORDS = ProgramView.entries.map(::wordFor)
