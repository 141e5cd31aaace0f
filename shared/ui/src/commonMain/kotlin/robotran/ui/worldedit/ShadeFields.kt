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
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.Shade
import kotlin.math.roundToInt

/** The colour of a mark: a swatch, any grey, or any colour as numbers, and its brightness for the robot's sensor. */
@Composable
internal fun ShadeFields(editor: EditorScope, shade: Shade, onChange: (Shade) -> Unit) {
    val onceChanged = { changed: Shade ->
        editor.settle()
        onChange(changed)
        editor.settle()
    }
    Column(Modifier.fillMaxWidth()) {
        Swatches(
            WorldEditorTexts.shade(spoken),
            SWATCHES.map { Swatch(it.first, colourOf(it.first), it.second(spoken)) },
            shade,
            "shade",
            onceChanged,
        )
        when (shade) {
            is Shade.Grey -> {
                NumberRow(
                    WorldEditorTexts.grey(spoken),
                    shade.reflectance,
                    0.0..1.0,
                    "field-grey",
                    { onChange(Shade.Grey(it)) },
                    editor::settle,
                    step = 0.05,
                    slider = 0f..1f,
                )
            }

            is Shade.Colour -> {
                PartField(editor, WorldEditorTexts.redPart(spoken), shade.red, "red") {
                    onChange(shade.copy(red = it))
                }
                PartField(editor, WorldEditorTexts.greenPart(spoken), shade.green, "green") {
                    onChange(shade.copy(green = it))
                }
                PartField(editor, WorldEditorTexts.bluePart(spoken), shade.blue, "blue") {
                    onChange(shade.copy(blue = it))
                }
            }
        }
        HelpText(WorldEditorTexts.seenBySensor(spoken, (shade.reflectance * 100).roundToInt()))
    }
}

@Composable
private fun PartField(editor: EditorScope, title: String, value: Int, tag: String, onChange: (Int) -> Unit) = NumberRow(
    title,
    value.toDouble(),
    0.0..MAX_PART,
    "field-$tag",
    { onChange(it.toInt()) },
    editor::settle,
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
        Text(title, style = TextStyles.compact)
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
                        .named(swatch.word)
                        .padding(4.dp),
                    Arrangement.spacedBy(2.dp),
                    Alignment.CenterHorizontally,
                ) {
                    Box(
                        Modifier.size(
                            28.dp,
                        ).background(swatch.colour, CircleShape).border(1.dp, colours.quiet, CircleShape),
                    )
                    Text(swatch.word, style = TextStyles.sign, maxLines = 1)
                }
            }
        }
    }
}

private fun colourOf(shade: Shade): Color = when (shade) {
    is Shade.Grey -> shade.reflectance.toFloat().let { Color(it, it, it) }
    is Shade.Colour -> Color(shade.red, shade.green, shade.blue)
}

private val SWATCHES: List<Pair<Shade, Label>> = listOf(
    Shade.Grey(0.0) to WorldEditorTexts::black,
    Shade.Grey(0.3) to WorldEditorTexts::darkGrey,
    Shade.Grey(0.6) to WorldEditorTexts::lightGrey,
    Shade.Grey(1.0) to WorldEditorTexts::white,
    Shade.Colour(200, 40, 30) to WorldEditorTexts::red,
    Shade.Colour(235, 130, 20) to WorldEditorTexts::orange,
    Shade.Colour(245, 205, 30) to WorldEditorTexts::yellow,
    Shade.Colour(40, 150, 70) to WorldEditorTexts::green,
    Shade.Colour(17, 51, 170) to WorldEditorTexts::blue,
    Shade.Colour(120, 60, 160) to WorldEditorTexts::purple,
)
private const val MAX_PART = 255.0
