package robotran.ui.editing

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.editing.Field
import robotran.editing.WorldEditorTexts
import robotran.editing.parseDecimal
import robotran.editing.written
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import kotlin.math.round

/** A number field with step buttons and, if there is a range for it, a slider. */
@Composable
internal fun <T : Any> NumberField(field: Field.Number<T>, scope: EditScope<T>) {
    val spec = field.spec
    val factor = if (spec.isPercent) PERCENT else 1.0
    val value = field.value * factor
    val range = spec.range.start * factor..spec.range.endInclusive * factor
    var draft by remember(field.tag) { mutableStateOf<String?>(null) }
    val accepted = { text: String -> parseDecimal(text)?.takeIf { it in range && (!spec.isWhole || it % 1.0 == 0.0) } }
    val change = { number: Double -> field.with(number / factor)?.let(scope::make) }
    val title = field.label(spoken)
    val label = if (spec.unit.isEmpty()) title else "$title (${spec.unit})"
    val wrong = WorldEditorTexts.range(spoken, written(range.start), written(range.endInclusive))
        .takeIf { draft?.let(accepted) == null && draft != null }
    val stepBy = { by: Double ->
        draft = null
        change((value + by).coerceIn(range))
        scope.settle()
    }
    Column(Modifier.fillMaxWidth()) {
        Row(Modifier.fillMaxWidth(), verticalAlignment = Alignment.CenterVertically) {
            Text(label, Modifier.weight(1f), TextStyles.compact)
            IconButton(EditIcons.SMALLER, WorldEditorTexts.less(spoken, label), WorldTags.less(field.tag)) {
                stepBy(-spec.step)
            }
            CompactField(
                draft ?: written(value),
                FieldWords(label, field.tag, wrong),
                Modifier.width(figureWidth()),
                CompactFieldKind.NUMBER,
                onLeft = {
                    draft = null
                    scope.settle()
                },
            ) { text ->
                draft = text
                accepted(text)?.let(change)
            }
            IconButton(EditIcons.LARGER, WorldEditorTexts.more(spoken, label), WorldTags.more(field.tag)) {
                stepBy(spec.step)
            }
        }
        if (wrong != null) FieldError(wrong)
        spec.slider?.let { slider ->
            val usual = slider.start.toFloat()..slider.endInclusive.toFloat()
            Slider(
                value.toFloat().coerceIn(usual),
                SliderWords(label, written(value), WorldTags.slider(field.tag)),
                Modifier.fillMaxWidth().defaultMinSize(minHeight = Dimensions.TARGET),
                usual,
                onSettle = scope::settle,
            ) {
                draft = null
                change(round(it / spec.step) * spec.step)
            }
        }
    }
}

/** The field grows with the text, but leaves room for its neighbours. */
@Composable
private fun figureWidth() = 68.dp * LocalDensity.current.fontScale.coerceIn(1f, 1.5f)

private const val PERCENT = 100.0
