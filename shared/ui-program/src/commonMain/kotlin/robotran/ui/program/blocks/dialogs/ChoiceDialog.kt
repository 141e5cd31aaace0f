package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** The words that may stand at [part]. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun ChoiceDialog(part: PhrasePart.Choice, scope: BlockScope, onClose: () -> Unit) {
    val line = scope.lineOf(part)
    val now = scope.inEnglish(scope.textOf(part))
    BlockDialogFrame(BlockTexts.choose(spoken), onClose) {
        FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
            part.options.forEachIndexed { index, option ->
                DialogButton(
                    line.optionOf(part, option),
                    ProgramTags.choice(index),
                    isChosen = option.equals(now, ignoreCase = true),
                ) {
                    scope.put(option)
                    onClose()
                }
            }
        }
    }
}
