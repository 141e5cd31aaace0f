package robotran.uikit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.foundation.selection.toggleable
import androidx.compose.material3.Slider
import androidx.compose.material3.Switch
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp

/** A choice of one of [choices], each with its label. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun <T> ChoiceOfOne(title: String, choices: List<Pair<T, String>>, chosen: T, tag: String, onChoose: (T) -> Unit) {
    Column(Modifier.selectableGroup().testTag(tag)) {
        Heading(title)
        FlowRow(horizontalArrangement = Arrangement.spacedBy(16.dp)) {
            choices.forEachIndexed { place, (value, words) ->
                val selected = value == chosen
                Row(
                    Modifier
                        .testTag(KitTags.at(tag, place))
                        .defaultMinSize(minHeight = Dimensions.TARGET)
                        .focusRing()
                        .selectable(selected, role = Role.RadioButton) { onChoose(value) }
                        .padding(end = 12.dp),
                    verticalAlignment = Alignment.CenterVertically,
                ) {
                    RadioMark(selected, Modifier.padding(12.dp))
                    Text(words, style = TextStyles.body)
                }
            }
        }
    }
}

/**
 * A slider for a size in [range]; [words] is its text. A finger chooses the size when it is lifted: the page would grow
 * under it, and the slider with it.
 */
@Composable
fun SizeSlider(
    title: String,
    value: Float,
    range: ClosedFloatingPointRange<Float>,
    steps: Int,
    words: (Float) -> String,
    tag: String,
    onChange: (Float) -> Unit,
) {
    var held by remember { mutableStateOf<Float?>(null) }
    val shown = held ?: value
    Column {
        Heading(title)
        Row(verticalAlignment = Alignment.CenterVertically) {
            Slider(shown, SliderWords(title, words(shown), tag), Modifier.weight(1f), range, steps, {
                held?.let(onChange)
                held = null
            }) { held = it }
            Text(words(shown), Modifier.padding(start = 16.dp).defaultMinSize(minWidth = 64.dp), TextStyles.body)
        }
    }
}

/** A switch with a title. */
@Composable
fun SwitchRow(title: String, on: Boolean, tag: String, onSwitch: (Boolean) -> Unit) {
    Row(
        Modifier
            .fillMaxWidth()
            .testTag(tag)
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .focusRing()
            .toggleable(on, role = Role.Switch, onValueChange = onSwitch),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(title, Modifier.weight(1f), TextStyles.lead.medium)
        SwitchMark(on)
    }
}

@Composable
private fun Heading(text: String) = Text(
    text,
    Modifier.padding(bottom = 4.dp).heading(),
    TextStyles.lead.medium,
)
