package robotran.ui.worldedit

import androidx.compose.foundation.background
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*

/** The tabs of the editor's panel. */
internal enum class EditTab(val title: Label) {
    CHOSEN(WorldEditorTexts::tabChosen),
    THINGS(WorldEditorTexts::tabThings),
    GOALS(WorldEditorTexts::tabGoals),
    WORLD(WorldEditorTexts::tabWorld),
}

/** @param tab null if none is open. */
@Composable
internal fun EditTabs(tab: EditTab?, onChoose: (EditTab) -> Unit) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Row(
        Modifier
            .fillMaxWidth()
            .background(colours.pane)
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .selectableGroup(),
        Arrangement.spacedBy(4.dp),
    ) {
        for (each in EditTab.entries) {
            val isOpen = each == tab
            Column(
                Modifier
                    .testTag("tab-edit-${each.name.lowercase()}")
                    .defaultMinSize(72.dp, Dimensions.TARGET)
                    .broughtIntoSight(isOpen)
                    .focusRing()
                    .selectable(isOpen, role = Role.Tab) { onChoose(each) }
                    .padding(horizontal = 12.dp),
                Arrangement.Center,
                Alignment.CenterHorizontally,
            ) {
                Text(
                    each.title(spoken),
                    Modifier.padding(top = 12.dp, bottom = 8.dp),
                    TextStyles.compact.strong,
                    color = if (isOpen) colours.onPane else colours.quiet,
                    maxLines = 1,
                )
                Box(Modifier.fillMaxWidth().height(3.dp).background(if (isOpen) colours.onPane else Color.Transparent))
            }
        }
    }
    HorizontalDivider()
}

@Composable
internal fun EditPanel(
    editor: EditorScope,
    tab: EditTab,
    onTab: (EditTab) -> Unit,
    newTitle: String,
    modifier: Modifier = Modifier,
) {
    val editing = editor.editing
    val errors = editing.errors.filter { tab == EditTab.CHOSEN && it.thing in editing.selection }
        .map { validationErrorText(editing.world, it) }
    key(tab, if (tab == EditTab.CHOSEN) editor.editing.selection else null) {
        FieldPanel("edit-panel", errors, "chosen-trouble", modifier) {
            when (tab) {
                EditTab.CHOSEN -> ChosenPanel(editor)
                EditTab.THINGS -> ElementsPanel(editor) { onTab(EditTab.CHOSEN) }
                EditTab.GOALS -> GoalsPanel(editor) { onTab(EditTab.CHOSEN) }
                EditTab.WORLD -> WorldPanel(editor, newTitle)
            }
        }
    }
}
