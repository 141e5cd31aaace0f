package robotran.ui.worldedit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.selectable
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import robotran.worldediting.listed

/** A list of all elements on the sheet, for selection without seeing or pointing. */
@Composable
internal fun ElementsPanel(editor: EditorScope, onChosen: () -> Unit) {
    HelpText(WorldEditorTexts.thingsHelp(spoken))
    for (thing in editor.world.listed().filter {
        it.kind != ElementKind.GOAL
    }) {
        ElementRow(editor, thing, 0.dp, onChosen)
    }
}

/** An element in a list, with a sign if it has an error. */
@Composable
internal fun ElementRow(editor: EditorScope, ref: ElementRef, indent: Dp, onChosen: () -> Unit) {
    val colours = LocalRobotranColours.current
    val isChosen = ref in editor.editing.selection
    Row(
        Modifier
            .fillMaxWidth()
            .testTag("thing-${ref.kind.name.lowercase()}-${ref.number}")
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .focusRing()
            .clip(Shapes.MEDIUM)
            .background(if (isChosen) colours.runningLine else Color.Transparent)
            .selectable(isChosen, role = Role.Button) {
                editor.make(WorldEdit.Select(ref, editor.editing.isMultiSelect))
                if (!editor.editing.isMultiSelect) onChosen()
            }
            .padding(start = 12.dp + indent, end = 12.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        Text(elementText(editor.world, ref), Modifier.weight(1f), TextStyles.body)
        if (editor.editing.errors.any { it.thing == ref }) {
            Box(Modifier.size(22.dp)) {
                Canvas(Modifier.matchParentSize()) { with(EditIcons.WARNING) { draw(colours.error) } }
            }
        }
    }
}
