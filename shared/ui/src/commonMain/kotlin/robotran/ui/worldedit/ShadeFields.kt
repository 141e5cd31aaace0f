package robotran.ui.worldedit

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
import androidx.compose.material3.Text
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
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Shapes
import robotran.ui.theme.TextSizes
import robotran.ui.theme.focusRing
import robotran.world.Shade
import kotlin.math.roundToInt

/** The colour of a mark: a swatch, any grey, or any colour as numbers, and its brightness for the robot's sensor. */
@Composable
internal fun ShadeFields(making: EditorScope, shade: Shade, onChange: (Shade) -> Unit) {
    val onceChanged = { changed: Shade ->
        making.settle()
        onChange(changed)
        making.settle()
    }
    Column(Modifier.fillMaxWidth()) {
        Swatches(
            stringResource(Res.string.worldedit_shade),
            SWATCHES.map { Swatch(it.first, colourOf(it.first), stringResource(it.second)) },
            shade,
            "shade",
            onceChanged,
        )
        when (shade) {
            is Shade.Grey -> {
                NumberRow(
                    stringResource(Res.string.worldedit_grey),
                    shade.reflectance,
                    0.0..1.0,
                    "field-grey",
                    { onChange(Shade.Grey(it)) },
                    making::settle,
                    step = 0.05,
                    slider = 0f..1f,
                )
            }

            is Shade.Colour -> {
                PartField(making, stringResource(Res.string.worldedit_red_part), shade.red, "red") {
                    onChange(shade.copy(red = it))
                }
                PartField(making, stringResource(Res.string.worldedit_green_part), shade.green, "green") {
                    onChange(shade.copy(green = it))
                }
                PartField(making, stringResource(Res.string.worldedit_blue_part), shade.blue, "blue") {
                    onChange(shade.copy(blue = it))
                }
            }
        }
        Remark(stringResource(Res.string.worldedit_seen_by_sensor, (shade.reflectance * 100).roundToInt()))
    }
}

@Composable
private fun PartField(making: EditorScope, title: String, value: Int, tag: String, onChange: (Int) -> Unit) = NumberRow(
    title,
    value.toDouble(),
    0.0..MAX_PART,
    "field-$tag",
    { onChange(it.toInt()) },
    making::settle,
    step = 5.0,
    isWhole = true,
    slider = 0f..MAX_PART.toFloat(),
)

/** A colour with its name. */
internal class Swatch<T>(val value: T, val colour: Color, val word: String)

@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun <T> Swatches(title: String, swatches: List<Swatch<T>>, chosen: T, tag: String, onChoose: (T) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        Text(title, color = colours.onPane, fontSize = TextSizes.COMPACT)
        FlowRow(Modifier.selectableGroup(), Arrangement.spacedBy(4.dp), Arrangement.spacedBy(4.dp)) {
            swatches.forEachIndexed { place, swatch ->
                val isChosen = swatch.value == chosen
                Column(
                    Modifier
                        .testTag("$tag-$place")
                        .defaultMinSize(64.dp, Dimensions.TARGET)
                        .focusRing()
                        .clip(Shapes.MEDIUM)
                        .background(if (isChosen) colours.runningLine else Color.Transparent)
                        .selectable(isChosen, role = Role.RadioButton) { onChoose(swatch.value) }
                        .semantics { contentDescription = swatch.word }
                        .padding(4.dp),
                    Arrangement.spacedBy(2.dp),
                    Alignment.CenterHorizontally,
                ) {
                    Box(
                        Modifier.size(
                            28.dp,
                        ).background(swatch.colour, CircleShape).border(1.dp, colours.quiet, CircleShape),
                    )
                    Text(swatch.word, color = colours.onPane, fontSize = TextSizes.SIGN, maxLines = 1)
                }
            }
        }
    }
}

private fun colourOf(shade: Shade): Color = when (shade) {
    is Shade.Grey -> shade.reflectance.toFloat().let { Color(it, it, it) }
    is Shade.Colour -> Color(shade.red, shade.green, shade.blue)
}

private val SWATCHES: List<Pair<Shade, StringResource>> = listOf(
    Shade.Grey(0.0) to Res.string.worldedit_black,
    Shade.Grey(0.3) to Res.string.worldedit_dark_grey,
    Shade.Grey(0.6) to Res.string.worldedit_light_grey,
    Shade.Grey(1.0) to Res.string.worldedit_white,
    Shade.Colour(200, 40, 30) to Res.string.worldedit_red,
    Shade.Colour(235, 130, 20) to Res.string.worldedit_orange,
    Shade.Colour(245, 205, 30) to Res.string.worldedit_yellow,
    Shade.Colour(40, 150, 70) to Res.string.worldedit_green,
    Shade.Colour(17, 51, 170) to Res.string.worldedit_blue,
    Shade.Colour(120, 60, 160) to Res.string.worldedit_purple,
)
private const val MAX_PART = 255.0
