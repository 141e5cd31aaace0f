package robotran.ui.worldedit

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
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.worldediting.parseDecimal
import robotran.worldediting.written

/**
 * A number field with step buttons and, if there is a range for it, a slider.
 *
 * @param unit the unit, shown after the title.
 * @param slider the usual part of [range]; null for no slider.
 */
@Composable
internal fun NumberRow(
    title: String,
    value: Double,
    range: ClosedRange<Double>,
    tag: String,
    onChange: (Double) -> Unit,
    onSettle: () -> Unit,
    step: Double = 1.0,
    unit: String = "",
    slider: ClosedFloatingPointRange<Float>? = null,
    isWhole: Boolean = false,
) {
    var draft by remember(tag) { mutableStateOf<String?>(null) }
    val accepted = { number: Double? -> number?.takeIf { it in range && (!isWhole || it % 1.0 == 0.0) } }
    val isWrong = draft != null && accepted(parseDecimal(draft.orEmpty())) == null
    val label = if (unit.isEmpty()) title else "$title ($unit)"
    val wrong = WorldEditorTexts.range(spoken, written(range.start), written(range.endInclusive)).takeIf {
        isWrong
    }
    val stepped = { by: Double ->
        draft = null
        onChange((value + by).coerceIn(range.start, range.endInclusive))
        onSettle()
    }
    Column(Modifier.fillMaxWidth()) {
        Row(Modifier.fillMaxWidth(), verticalAlignment = Alignment.CenterVertically) {
            Text(label, Modifier.weight(1f), TextStyles.compact)
            IconButton(EditIcons.SMALLER, WorldEditorTexts.less(spoken, label), "$tag-less") {
                stepped(-step)
            }
            EditFieldBox(isWrong, Modifier.width(figureWidth())) {
                EditField(
                    text = draft ?: written(value),
                    label = label,
                    tag = tag,
                    wrong = wrong,
                    onText = { text ->
                        draft = text
                        accepted(parseDecimal(text))?.let(onChange)
                    },
                    onLeft = {
                        draft = null
                        onSettle()
                    },
                    number = true,
                )
            }
            IconButton(EditIcons.LARGER, WorldEditorTexts.more(spoken, label), "$tag-more") {
                stepped(step)
            }
        }
        if (wrong != null) Wrong(wrong)
        if (slider != null) {
            NumberSlider(label, value, slider, step, "$tag-slider", {
                draft = null
                onChange(it)
            }, onSettle)
        }
    }
}

/** The field grows with the text, but leaves room for its neighbours. */
@Composable
private fun figureWidth() = 68.dp * LocalDensity.current.fontScale.coerceIn(1f, 1.5f)

@Composable
private fun NumberSlider(
    label: String,
    value: Double,
    range: ClosedFloatingPointRange<Float>,
    step: Double,
    tag: String,
    onChange: (Double) -> Unit,
    onSettle: () -> Unit,
) {
    Slider(
        value.toFloat().coerceIn(range),
        SliderWords(label, written(value), tag),
        Modifier.fillMaxWidth().defaultMinSize(minHeight = Dimensions.TARGET),
        range,
        onSettle = onSettle,
    ) { onChange(kotlin.math.round(it / step) * step) }
}
