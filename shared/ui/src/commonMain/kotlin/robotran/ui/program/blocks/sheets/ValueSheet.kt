package robotran.ui.program.blocks.sheets

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.BlockEdit
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueKind
import robotran.robolang.words.ValueUse
import robotran.ui.program.blocks.BlockScope
import robotran.ui.resources.*

/** What may stand at [part]: a number, a name, or another value. */
@Composable
internal fun ValueSheet(part: PhrasePart.Value, scope: BlockScope, onClose: () -> Unit) {
    val takesNumber = part.use.kind == ValueKind.NUMBER || part.use.kind == ValueKind.UNKNOWN
    SheetFrame(stringResource(if (takesNumber) Res.string.blocks_number else Res.string.blocks_choose), onClose) {
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
