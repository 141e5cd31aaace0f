package robotran.ui.program.blocks.dialogs

import androidx.compose.runtime.Composable
import robotran.blockediting.BlockEdit
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueKind
import robotran.robolang.words.ValueUse
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** What may stand at [part]: a number, a name, or another value. */
@Composable
internal fun ValueDialog(part: PhrasePart.Value, scope: BlockScope, onClose: () -> Unit) {
    val takesNumber = part.use.kind == ValueKind.NUMBER || part.use.kind == ValueKind.UNKNOWN
    BlockDialogFrame(if (takesNumber) BlockTexts.number(spoken) else BlockTexts.choose(spoken), onClose) {
        if (takesNumber) NumberEditor(part, scope, onClose)
        if (part.use == ValueUse.FREQUENCY) NoteChoice(part, scope)
        ItemActions(part, scope)
        ValueChoices(part, scope) {
            scope.put(it)
            onClose()
        }
        NewName(scope) {
            scope.edit(BlockEdit.UseNewName(part.span, it))
            onClose()
        }
    }
}
