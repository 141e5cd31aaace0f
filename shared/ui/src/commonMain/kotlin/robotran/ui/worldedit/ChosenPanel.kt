package robotran.ui.worldedit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.Icon
import robotran.ui.resources.*
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.worldediting.AlignSide
import robotran.worldediting.Edit
import robotran.worldediting.ElementKind
import robotran.worldediting.StackOrder
import robotran.worldediting.WorldEditing
import robotran.worldediting.canRotate
import robotran.worldediting.form
import robotran.worldediting.piece

/** The selection: its actions and properties. */
@Composable
internal fun ChosenPanel(making: EditorScope) {
    val editing = making.editing
    if (editing.selection.isEmpty()) {
        Remark(stringResource(Res.string.worldedit_choose_first))
        return
    }
    val only = editing.only
    Text(
        chosenTitle(editing),
        Modifier.testTag("chosen-name").semantics { heading() },
        color = LocalRobotranColours.current.onPane,
        fontSize = TextSizes.LEAD,
        fontWeight = FontWeight.SemiBold,
    )
    Actions(making)
    HorizontalDivider(color = LocalRobotranColours.current.line)
    val piece = only?.let { editing.world.piece(it) }
    if (only != null && piece != null) ElementFields(making, only, piece)
    if (editing.hasPlace) {
        RowHeading(stringResource(if (only != null) Res.string.worldedit_align_paper else Res.string.worldedit_align))
        AlignRow(making)
    }
}

@Composable
private fun chosenTitle(editing: WorldEditing): String {
    val only = editing.only ?: return stringResource(Res.string.worldedit_several_chosen, editing.selection.size)
    return elementText(editing.world, only)
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Actions(making: EditorScope) {
    val editing = making.editing
    val turn = turnStep(editing)
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        Action(EditIcons.DELETE, Res.string.worldedit_delete, "delete") { making.make(Edit.Delete) }
        Action(EditIcons.COPY, Res.string.worldedit_duplicate, "duplicate") { making.make(Edit.Duplicate) }
        if (editing.canRotate) {
            Action(EditIcons.TURN_LEFT, Res.string.worldedit_turn_left, "turn-left") { making.make(Edit.TurnBy(turn)) }
            Action(EditIcons.TURN_RIGHT, Res.string.worldedit_turn_right, "turn-right") {
                making.make(Edit.TurnBy(-turn))
            }
        }
        if (editing.selection.any { it.kind != ElementKind.ROBOT && it.kind != ElementKind.LAMP } && editing.hasPlace) {
            Action(EditIcons.LARGER, Res.string.worldedit_larger, "larger") { making.make(Edit.ScaleBy(GROWTH)) }
            Action(EditIcons.SMALLER, Res.string.worldedit_smaller, "smaller") { making.make(Edit.ScaleBy(1 / GROWTH)) }
        }
        if (editing.selection.any { it.kind == ElementKind.MARK }) {
            Action(EditIcons.FRONT, Res.string.worldedit_to_front, "to-front") {
                making.make(Edit.Restack(StackOrder.TO_FRONT))
            }
            Action(EditIcons.UP, Res.string.worldedit_forward, "forward") {
                making.make(Edit.Restack(StackOrder.FORWARD))
            }
            Action(EditIcons.DOWN, Res.string.worldedit_backward, "backward") {
                making.make(Edit.Restack(StackOrder.BACK))
            }
            Action(EditIcons.BACK, Res.string.worldedit_to_back, "to-back") {
                making.make(Edit.Restack(StackOrder.TO_BACK))
            }
        }
        if (editing.selection.size > 1) {
            Action(EditIcons.GROUP, Res.string.worldedit_group, "group") { making.make(Edit.Group) }
        }
        if (editing.groups.any { group -> group.any { it in editing.selection } }) {
            Action(EditIcons.UNGROUP, Res.string.worldedit_ungroup, "ungroup") { making.make(Edit.Ungroup) }
        }
    }
}

@Composable
private fun Action(icon: Icon, word: StringResource, tag: String, onClick: () -> Unit) =
    IconWord(icon, stringResource(word), tag, onClick)

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun AlignRow(making: EditorScope) {
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        for (side in AlignSide.entries) {
            val tag = "align-${side.name.lowercase()}"
            IconWord(EditIcons.align(side), stringResource(alignWord(side)), tag, { making.make(Edit.Align(side)) })
        }
    }
}

/** Whether a selected element has a place on the sheet. */
private val WorldEditing.hasPlace: Boolean get() = selection.any { world.piece(it)?.form != null }

private val WorldEditing.canRotate: Boolean
    get() = if (selection.size > 1) hasPlace else selection.any { world.piece(it)?.form?.canRotate == true }

private fun alignWord(side: AlignSide): StringResource = when (side) {
    AlignSide.LEFT -> Res.string.worldedit_align_left
    AlignSide.CENTRE -> Res.string.worldedit_align_centre
    AlignSide.RIGHT -> Res.string.worldedit_align_right
    AlignSide.TOP -> Res.string.worldedit_align_top
    AlignSide.MIDDLE -> Res.string.worldedit_align_middle
    AlignSide.BOTTOM -> Res.string.worldedit_align_bottom
}
