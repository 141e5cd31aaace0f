package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.RobotColours
import robotran.uikit.*
import robotran.world.RobotColour
import robotran.world.Shade

/** A choice of colours, each with its name. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun <T> Swatches(
    title: String,
    choices: List<Pair<T, String>>,
    chosen: T,
    tag: String,
    onChoose: (T) -> Unit,
) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        Text(title, style = TextStyles.compact)
        FlowRow(Modifier.selectableGroup(), Arrangement.spacedBy(4.dp), Arrangement.spacedBy(4.dp)) {
            choices.forEachIndexed { place, (value, word) ->
                val isChosen = value == chosen
                Column(
                    Modifier
                        .testTag(KitTags.at(tag, place))
                        .defaultMinSize(64.dp, Dimensions.TARGET)
                        .focusRing()
                        .clip(Shapes.MEDIUM)
                        .background(if (isChosen) colours.runningLine else Color.Transparent)
                        .selectable(isChosen, role = Role.RadioButton) { onChoose(value) }
                        .semantics { contentDescription = word }
                        .padding(4.dp),
                    Arrangement.spacedBy(2.dp),
                    Alignment.CenterHorizontally,
                ) {
                    Box(
                        Modifier.size(
                            28.dp,
                        ).background(colourOf(value), CircleShape).border(1.dp, colours.quiet, CircleShape),
                    )
                    Text(word, style = TextStyles.sign, maxLines = 1)
                }
            }
        }
    }
}

private fun colourOf(value: Any?): Color = when (value) {
    is RobotColour -> RobotColours.brick(value)
    is Shade.Grey -> value.reflectance.toFloat().let { Color(it, it, it) }
    is Shade.Colour -> Color(value.red, value.green, value.blue)
    else -> Color.Transparent
}
