package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import robotran.blockediting.BlockEdit
import robotran.blockediting.nameAt
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueUse
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** Adds and deletes elements at the end of the list at [part]; nothing if no list is written there. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun ItemActions(part: PhrasePart.Value, scope: BlockScope) {
    if (part.value.form != ValueForm.LIST) return
    val count = part.value.parts.count { it is PhrasePart.Value }
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        DialogButton(BlockTexts.itemAdd(spoken), ProgramTags.ITEM_ADD) {
            scope.edit(BlockEdit.AddItem(part.span, count, ValueUse.NUMBER.example))
        }
        if (count > 1) {
            DialogButton(BlockTexts.itemRemove(spoken), ProgramTags.ITEM_REMOVE) {
                scope.edit(BlockEdit.RemoveItem(part.span, count - 1))
            }
        }
    }
}

/** Adds and deletes the last parameter of the own command that [part] declares, in all its calls, too. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun ParameterActions(part: PhrasePart.NamePart, scope: BlockScope, onClose: () -> Unit) {
    val routine = scope.state.program.nameAt(part.span) ?: return
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        DialogButton(BlockTexts.parameterAdd(spoken), ProgramTags.PARAMETER_ADD) {
            scope.edit(BlockEdit.AddParameter(routine.declaredAt, scope.freeName()))
            onClose()
        }
        if (routine.parameters.isNotEmpty()) {
            DialogButton(BlockTexts.parameterRemove(spoken), ProgramTags.PARAMETER_REMOVE) {
                scope.edit(BlockEdit.RemoveParameter(routine.declaredAt, routine.parameters.lastIndex))
                onClose()
            }
        }
    }
}
