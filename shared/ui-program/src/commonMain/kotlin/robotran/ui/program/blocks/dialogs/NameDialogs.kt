package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.dp
import robotran.blockediting.BlockEdit
import robotran.blockediting.nameAt
import robotran.blockediting.namesFor
import robotran.robolang.outline.NameRole
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** Where a name is declared, it can be renamed everywhere; elsewhere another one can be chosen, or a new one made. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun NameDialog(part: PhrasePart.NamePart, scope: BlockScope, onClose: () -> Unit) {
    val isDeclaration = part.role == NameRole.DECLARES || part.role == NameRole.DECLARES_ROUTINE
    BlockDialogFrame(if (isDeclaration) BlockTexts.rename(spoken) else BlockTexts.names(spoken), onClose) {
        if (isDeclaration) {
            DialogField(scope.textOf(part), BlockTexts.name(spoken), ProgramTags.NAME) { name ->
                val declared = scope.state.program.nameAt(part.span)
                if (declared == null) scope.put(name) else scope.edit(BlockEdit.Rename(declared.declaredAt, name))
                onClose()
            }
            if (part.role == NameRole.DECLARES_ROUTINE) ParameterActions(part, scope, onClose)
        } else {
            FlowRow(
                horizontalArrangement = Arrangement.spacedBy(8.dp),
                verticalArrangement = Arrangement.spacedBy(8.dp),
            ) {
                scope.state.program.namesFor(part).forEachIndexed { index, name ->
                    DialogButton(name.text, ProgramTags.name(index), isChosen = name.text == scope.textOf(part)) {
                        scope.put(name.text)
                        onClose()
                    }
                }
            }
            NewName(scope) {
                scope.edit(BlockEdit.UseNewName(part.span, it))
                onClose()
            }
        }
    }
}

/** A button that becomes a field for a new name. */
@Composable
internal fun NewName(scope: BlockScope, onName: (String) -> Unit) {
    var isOpen by remember { mutableStateOf(false) }
    if (isOpen) {
        DialogField(scope.freeName(), BlockTexts.name(spoken), ProgramTags.NEW_NAME, onDone = onName)
    } else {
        DialogButton(BlockTexts.nameNew(spoken), ProgramTags.NEW_NAME) { isOpen = true }
    }
}
