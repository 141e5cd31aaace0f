package robotran.uikit

import androidx.compose.material3.SliderDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.material3.Slider as MaterialSlider

/**
 * A slider over [range]; see [SliderWords] for what screen readers say.
 *
 * @param steps how many places there are between the ends; 0 for any.
 * @param onSettle is called when it is let go.
 */
@Composable
fun Slider(
    value: Float,
    words: SliderWords,
    modifier: Modifier = Modifier,
    range: ClosedFloatingPointRange<Float> = 0f..1f,
    steps: Int = 0,
    onSettle: (() -> Unit)? = null,
    onChange: (Float) -> Unit,
) {
    val colours = LocalRobotranColours.current
    MaterialSlider(
        value,
        onChange,
        modifier.testTag(words.tag).focusRing().semantics {
            contentDescription = words.name
            stateDescription = words.value
        },
        onValueChangeFinished = onSettle,
        valueRange = range,
        steps = steps,
        colors = SliderDefaults.colors(
            thumbColor = colours.onPane,
            activeTrackColor = colours.onPane,
            inactiveTrackColor = colours.line,
            activeTickColor = colours.pane,
            inactiveTickColor = colours.quiet,
        ),
    )
}

/** The [name] of a slider, its [value] in words, and its [tag]. */
class SliderWords(val name: String, val value: String, val tag: String)
