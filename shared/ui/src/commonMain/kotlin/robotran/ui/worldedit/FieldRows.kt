package robotran.ui.worldedit

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.material3.Slider
import androidx.compose.material3.SliderDefaults
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.error
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.IconTouch
import robotran.ui.resources.Res
import robotran.ui.resources.worldedit_less
import robotran.ui.resources.worldedit_more
import robotran.ui.resources.worldedit_range
import robotran.ui.resources.worldedit_text_range
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing
import robotran.worldediting.isText
import robotran.worldediting.readFigure
import robotran.worldediting.written

/** A heading between rows. */
@Composable
internal fun RowHeading(text: String) = Text(
    text,
    Modifier.padding(top = 12.dp, bottom = 2.dp).semantics { heading() },
    color = LocalRobotranColours.current.onPane,
    fontSize = 16.sp,
    fontWeight = FontWeight.SemiBold,
)

/** A sentence of help, or of nothing to be seen. */
@Composable
internal fun Remark(text: String, modifier: Modifier = Modifier) =
    Text(text, modifier.padding(vertical = 6.dp), color = LocalRobotranColours.current.quiet, fontSize = 15.sp)

/**
 * A number that can be typed and stepped, and drawn with a slider if there is a range for one.
 *
 * @param unit what it counts, behind the title.
 * @param slider the part of [range] that is usual; null for no slider.
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
    val isWrong = draft != null && accepted(readFigure(draft.orEmpty())) == null
    val label = if (unit.isEmpty()) title else "$title ($unit)"
    val wrong = stringResource(Res.string.worldedit_range, written(range.start), written(range.endInclusive)).takeIf { isWrong }
    val stepped = { by: Double ->
        draft = null
        onChange((value + by).coerceIn(range.start, range.endInclusive))
        onSettle()
    }
    Column(Modifier.fillMaxWidth()) {
        Row(Modifier.fillMaxWidth(), verticalAlignment = Alignment.CenterVertically) {
            Text(label, Modifier.weight(1f), color = LocalRobotranColours.current.onPane, fontSize = 15.sp)
            IconTouch(EditIcons.SMALLER, stringResource(Res.string.worldedit_less, label), "$tag-less", { stepped(-step) })
            FieldBox(isWrong, Modifier.width(figureWidth())) {
                Field(
                    text = draft ?: written(value),
                    label = label,
                    tag = tag,
                    wrong = wrong,
                    onText = { text ->
                        draft = text
                        accepted(readFigure(text))?.let(onChange)
                    },
                    onLeft = {
                        draft = null
                        onSettle()
                    },
                    number = true,
                )
            }
            IconTouch(EditIcons.LARGER, stringResource(Res.string.worldedit_more, label), "$tag-more", { stepped(step) })
        }
        if (wrong != null) Wrong(wrong)
        if (slider != null) {
            FigureSlider(label, value, slider, step, "$tag-slider", {
                draft = null
                onChange(it)
            }, onSettle)
        }
    }
}

/** The field grows with the text, but leaves room for what stands beside it. */
@Composable
private fun figureWidth() = 68.dp * LocalDensity.current.fontScale.coerceIn(1f, 1.5f)

@Composable
private fun FigureSlider(
    label: String,
    value: Double,
    range: ClosedFloatingPointRange<Float>,
    step: Double,
    tag: String,
    onChange: (Double) -> Unit,
    onSettle: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    Slider(
        value.toFloat().coerceIn(range),
        { onChange(kotlin.math.round(it / step) * step) },
        Modifier.fillMaxWidth().defaultMinSize(minHeight = Measures.TARGET).testTag(tag).focusRing().semantics {
            contentDescription = label
            stateDescription = written(value)
        },
        valueRange = range,
        onValueChangeFinished = onSettle,
        colors = SliderDefaults.colors(thumbColor = colours.onPane, activeTrackColor = colours.onPane, inactiveTrackColor = colours.line),
    )
}

/**
 * A line of text, or several if it is [tall].
 *
 * @param maximum its most characters.
 * @param onChange is given only what can be taken.
 */
@Composable
internal fun TextRow(
    title: String,
    text: String,
    maximum: Int,
    tag: String,
    onChange: (String) -> Unit,
    onSettle: () -> Unit,
    mayBeBlank: Boolean = false,
    tall: Boolean = false,
    hint: String = "",
    refusal: String? = null,
) {
    var draft by remember(tag) { mutableStateOf<String?>(null) }
    val typed = draft
    val isWrong = typed != null && !tall && !isText(typed, maximum, mayBeBlank)
    val wrong = if (isWrong) stringResource(Res.string.worldedit_text_range, maximum) else refusal.takeIf { typed != null && typed != text }
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        Text(title, color = LocalRobotranColours.current.onPane, fontSize = 15.sp)
        FieldBox(wrong != null, Modifier.fillMaxWidth()) {
            Field(
                text = typed ?: text,
                label = title,
                tag = tag,
                wrong = wrong,
                onText = {
                    draft = it
                    if (tall || isText(it, maximum, mayBeBlank)) onChange(it)
                },
                onLeft = {
                    draft = null
                    onSettle()
                },
                tall = tall,
                hint = hint,
            )
        }
        if (wrong != null) Wrong(wrong)
    }
}

@Composable
private fun FieldBox(isWrong: Boolean, modifier: Modifier, field: @Composable () -> Unit) {
    val colours = LocalRobotranColours.current
    Box(
        modifier
            .defaultMinSize(minHeight = Measures.TARGET)
            .focusRing(FIELD_CORNER)
            .background(if (colours.isDark) colours.desk else colours.paper, RoundedCornerShape(FIELD_CORNER))
            .border(if (isWrong) 2.dp else 1.dp, if (isWrong) colours.mistake else colours.quiet, RoundedCornerShape(FIELD_CORNER)),
        Alignment.Center,
    ) { field() }
}

@Composable
private fun Field(
    text: String,
    label: String,
    tag: String,
    wrong: String?,
    onText: (String) -> Unit,
    onLeft: () -> Unit,
    number: Boolean = false,
    tall: Boolean = false,
    hint: String = "",
) {
    val colours = LocalRobotranColours.current
    var focused by remember { mutableStateOf(false) }
    BasicTextField(
        value = text,
        onValueChange = onText,
        modifier = Modifier
            .fillMaxWidth()
            .padding(horizontal = 8.dp, vertical = 10.dp)
            .testTag(tag)
            .onFocusChanged {
                if (focused && !it.isFocused) onLeft()
                focused = it.isFocused
            }
            .semantics {
                contentDescription = label
                if (wrong != null) error(wrong)
            },
        textStyle = TextStyle(colours.onPane, fontSize = 16.sp, textAlign = if (number) TextAlign.Center else TextAlign.Start),
        keyboardOptions = KeyboardOptions(keyboardType = if (number) KeyboardType.Decimal else KeyboardType.Text),
        singleLine = !tall,
        minLines = if (tall) TALL_LINES else 1,
        cursorBrush = SolidColor(colours.onPane),
        decorationBox = { inner ->
            if (text.isEmpty() && hint.isNotEmpty()) Text(hint, color = colours.quiet, fontSize = 16.sp)
            inner()
        },
    )
}

/** What is wrong, under a field. */
@Composable
internal fun Wrong(text: String, modifier: Modifier = Modifier) = Text(
    text,
    modifier.semantics { liveRegion = LiveRegionMode.Polite },
    color = LocalRobotranColours.current.mistake,
    fontSize = 14.sp,
)

private val FIELD_CORNER = 8.dp
private const val TALL_LINES = 4
