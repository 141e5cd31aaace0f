package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.MUSICAL_NOTES
import robotran.blockediting.palette.offeredNames
import robotran.blockediting.palette.offeredValues
import robotran.blockediting.shown.shownValue
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** The names and the values of the palette that fit at [part]. */
@Composable
internal fun ValueChoices(part: PhrasePart.Value, scope: BlockScope, onChoose: (String) -> Unit) {
    val program = scope.state.program
    val names = program.offeredNames(part)
    if (names.isNotEmpty()) {
        DialogHeading(BlockTexts.names(spoken))
        Choices(names, ProgramTags.VALUE_NAME, onChoose)
    }
    DialogHeading(BlockTexts.values(spoken))
    val values = program.offeredValues(part, scope.sensors, scope.brick)
    Choices(values.map { program.shownValue(it) to it }, ProgramTags.VALUE, now = null, onChoose)
}

/** The tones of a keyboard, for `play`. */
@Composable
internal fun NoteChoice(part: PhrasePart.Value, scope: BlockScope) {
    DialogHeading(BlockTexts.tones(spoken))
    Choices(MUSICAL_NOTES.map { it.name to "${it.frequency}" }, ProgramTags.TONE, scope.textOf(part)) {
        scope.put(it)
    }
}

/** Buttons side by side; each puts into the program what it says. */
@Composable
private fun Choices(choices: List<String>, tag: String, onChoose: (String) -> Unit) =
    Choices(choices.map { it to it }, tag, now = null, onChoose)

/**
 * Buttons side by side.
 *
 * @param choices the words of each, and what it puts into the program.
 * @param now what the program has.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Choices(choices: List<Pair<String, String>>, tag: String, now: String?, onChoose: (String) -> Unit) =
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        choices.forEachIndexed { index, (words, text) ->
            DialogButton(words, KitTags.at(tag, index), isChosen = text == now) { onChoose(text) }
        }
    }
