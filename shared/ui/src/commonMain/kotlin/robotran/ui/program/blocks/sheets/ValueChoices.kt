package robotran.ui.program.blocks.sheets

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.fits
import robotran.blockediting.namesFor
import robotran.blockediting.palette.MUSICAL_NOTES
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.palette.comparisonsFor
import robotran.blockediting.palette.textAt
import robotran.blockediting.palette.valueForm
import robotran.blockediting.palette.valueKind
import robotran.brick.kind.BrickKind
import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.NameKind
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ValueForm
import robotran.robolang.outline.ValueKind
import robotran.robolang.outline.ValueUse
import robotran.ui.program.blocks.BlockScope
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_names
import robotran.ui.resources.blocks_tones
import robotran.ui.resources.blocks_values

/** The names and the values of the palette that fit at [part]. */
@Composable
internal fun ValueChoices(part: PhrasePart.Value, scope: BlockScope, onChoose: (String) -> Unit) {
    val names = scope.state.program.namesFor(part)
    if (names.isNotEmpty()) {
        SheetHeading(stringResource(Res.string.blocks_names))
        Choices(names.map { textFor(it) to textFor(it) }, "value-name", onChoose)
    }
    SheetHeading(stringResource(Res.string.blocks_values))
    val fitting = VALUES.getValue(scope.brick).filter { (_, kind) -> fits(kind, part.use) }
    // Comparisons of the robot's own sensors come first.
    val (comparisons, others) = fitting.map { it.first }.partition { it.valueForm == ValueForm.COMPARISON }
    val compared = if (comparisons.isEmpty()) emptyList() else comparisonsFor(scope.sensors, scope.brick)
    val choices = compared.map { it to it } + others.map { it.template to it.textAt(part, scope.state.program) }
    Choices(choices, "value", onChoose)
}

/** The tones of a keyboard, for `play`. */
@Composable
internal fun NoteChoice(part: PhrasePart.Value, scope: BlockScope) {
    SheetHeading(stringResource(Res.string.blocks_tones))
    Choices(MUSICAL_NOTES.map { it.name to "${it.frequency}" }, "tone", scope.textOf(part)) {
        scope.put(it)
    }
}

@Composable
private fun Choices(choices: List<Pair<String, String>>, tag: String, onChoose: (String) -> Unit) =
    Choices(choices, tag, now = null, onChoose)

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
            SheetButton(words, "$tag-$index", isChosen = text == now) { onChoose(text) }
        }
    }

/** A name as a value: a function is called with an example for each parameter. */
private fun textFor(name: DeclaredName): String = if (name.kind == NameKind.FUNCTION) {
    name.parameters.joinToString(prefix = "${name.text}(", postfix = ")") { ValueUse.ANY.example }
} else {
    name.text
}

/** The values of the palette with their types, without plain numbers, which the number pad writes, and brackets. */
private val VALUES: Map<BrickKind, List<Pair<PaletteBlock, ValueKind>>> by lazy {
    BrickKind.entries.associateWith { brick ->
        Palette.blocksFor(brick).filter { it.isValue && it.valueForm !in UNOFFERED }.map { it to it.valueKind }
    }
}

internal val UNOFFERED = setOf(ValueForm.NUMBER, ValueForm.BRACKETS)
