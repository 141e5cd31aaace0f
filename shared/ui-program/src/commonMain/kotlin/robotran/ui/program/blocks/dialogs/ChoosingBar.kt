package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.blockediting.BlockEdit
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.copy
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*
import robotran.workshop.event.BlockEvent

/** How many blocks are chosen, and what can be done to all of them. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun ChoosingBar(scope: BlockScope) {
    val clipboard = LocalClipboardManager.current
    val state = scope.state
    Surface(
        Modifier.fillMaxWidth().padding(8.dp).testTag(ProgramTags.BLOCKS_CHOOSING),
        Shapes.LARGE,
        shadowElevation = 6.dp,
    ) {
        Column(Modifier.padding(12.dp), Arrangement.spacedBy(8.dp)) {
            Text(
                BlockTexts.chosen(spoken, state.selected.size),
                Modifier.announced(),
                TextStyles.label,
            )
            FlowRow(
                horizontalArrangement = Arrangement.spacedBy(8.dp),
                verticalArrangement = Arrangement.spacedBy(8.dp),
            ) {
                DialogButton(BlockTexts.done(spoken), ProgramTags.CHOOSING_DONE) {
                    scope.onEvent(BlockEvent.MultiSelectChanged(false))
                }
                DialogButton(EditorTexts.copy(spoken), ProgramTags.CHOOSING_COPY) { clipboard.copy(scope) }
                DialogButton(BlockTexts.duplicate(spoken), ProgramTags.CHOOSING_DUPLICATE) {
                    state.run?.let { scope.edit(BlockEdit.Duplicate(it)) }
                }
                DialogButton(BlockTexts.delete(spoken), ProgramTags.CHOOSING_DELETE) {
                    scope.edit(BlockEdit.Delete(state.selected.toSet()))
                }
            }
        }
    }
}
