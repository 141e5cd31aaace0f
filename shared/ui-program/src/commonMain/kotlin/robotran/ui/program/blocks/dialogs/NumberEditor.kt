package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.coerceAtMost
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.blockediting.NumberScale
import robotran.blockediting.scale
import robotran.editing.written
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueUse
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import kotlin.math.round

/**
 * The number at [part]: buttons for a little less and more, a slider or a dial, and a number pad. Everything changes
 * the program at once, and is undone together when the sheet has closed.
 */
@Composable
internal fun NumberEditor(part: PhrasePart.Value, scope: BlockScope, onClose: () -> Unit) {
    // Digits that come before the next frame go on with what is typed, so it is not worked out from the program.
    var typed by remember { mutableStateOf(TypedNumber(null)) }
    val inProgram = scope.textOf(part)
    LaunchedEffect(inProgram) {
        // On the sheet of paper, the number is changed without typing.
        if (typed.number != null && typed.number != inProgram) typed = TypedNumber(null)
    }
    val focus = remember { FocusRequester() }
    val scale = part.use.scale ?: DEFAULT_SCALE
    val now = scope.numberIn(part)
    val put = { number: Double ->
        typed = TypedNumber(null)
        if (number != now) scope.put(written(number))
    }
    val step = { by: Double -> put(round(((now ?: 0.0) + by) / SMALLEST) * SMALLEST) }
    val type = { next: TypedNumber ->
        typed = next
        next.number?.takeIf { it != scope.textOf(part) }?.let { scope.put(it) }
        Unit
    }
    val preview = previewWords(part, scope)
    val label = BlockTexts.number(spoken)
    val keys = NumberKeys(typed, scope.textOf(part), type, { step(it * scale.step) }, onClose)
    LaunchedEffect(Unit) { focus.requestFocus() }
    Column(
        Modifier
            .fillMaxWidth()
            .onPreviewKeyEvent(keys::handle)
            .focusRequester(focus)
            .focusable()
            .testTag(ProgramTags.NUMBER)
            .semantics {
                contentDescription = label
                preview?.let { stateDescription = it }
            },
        Arrangement.spacedBy(8.dp),
    ) {
        val unit = scope.shown(part.use.unit.orEmpty())
        val isOver = LocalSheetPlace.current == SheetPlace.OVER
        NumberBeside(isOver, { room, width ->
            Stepper(typed.text?.let(scope::shownNumber) ?: scope.labelOf(part), unit, room, {
                step(-scale.step)
            }, { step(scale.step) }) {
                if (part.use == ValueUse.ANGLE && !isOver) {
                    AngleDial(now ?: 0.0, isLeft(part, scope), width.coerceAtMost(DIAL), put)
                } else {
                    NumberSlider(now ?: scale.min, scale, scope, put)
                }
            }
        }) { keyWidth ->
            NumberPad(keyWidth, isOver, scope.state.program.shown.language.decimalSign, onClose) { sign ->
                type(typed.with(sign, scope.textOf(part)))
            }
        }
    }
}

/**
 * [number] beside [pad], so that all is reached without scrolling; above it if the text is large.
 *
 * @param isLow whether the pad has two rows only.
 * @param number receives how much room it has, and its width.
 * @param pad receives the width of a key.
 */
@Composable
private fun NumberBeside(isLow: Boolean, number: @Composable (NumberRoom, Dp) -> Unit, pad: @Composable (Dp) -> Unit) =
    BoxWithConstraints(Modifier.fillMaxWidth()) {
        val whole = maxWidth
        val keyWidth = if (whole >= ROOMY && !isLow) KEY else Dimensions.TARGET
        val rest = whole - padWidth(keyWidth, isLow) - BETWEEN
        val scale = LocalDensity.current.fontScale.coerceIn(1f, MOST_SCALE)
        if (rest >= LEAST * if (isLow) 1f else scale) {
            val forStepper = if (isLow) FOR_LOW_STEPPER * scale else FOR_STEPPER
            Row(
                Modifier.fillMaxWidth(),
                Arrangement.spacedBy(BETWEEN, Alignment.CenterHorizontally),
                Alignment.CenterVertically,
            ) {
                Column(
                    Modifier.weight(1f, fill = false).widthIn(max = WIDEST),
                    Arrangement.spacedBy(4.dp),
                    Alignment.CenterHorizontally,
                ) { number(if (rest >= forStepper) NumberRoom.BROAD else NumberRoom.NARROW, minOf(rest, WIDEST)) }
                pad(keyWidth)
            }
        } else {
            Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp), Alignment.CenterHorizontally) {
                number(NumberRoom.BROAD, whole)
                pad(keyWidth)
            }
        }
    }

/** How the number, its buttons and its slider are arranged. */
private enum class NumberRoom {
    /** The number, the slider, and the buttons below each other. */
    NARROW,

    /** The number between the buttons, and the slider below. */
    BROAD,
}

/** The number with its buttons and its [slider]. */
@Composable
private fun Stepper(
    text: String,
    unit: String,
    room: NumberRoom,
    onLess: () -> Unit,
    onMore: () -> Unit,
    slider: @Composable () -> Unit,
) {
    val less: @Composable () -> Unit = {
        DialogButton("−", ProgramTags.NUMBER_LESS, spoken = BlockTexts.less(spoken), onClick = onLess)
    }
    val more: @Composable () -> Unit = {
        DialogButton("+", ProgramTags.NUMBER_MORE, spoken = BlockTexts.moreOf(spoken), onClick = onMore)
    }
    if (room == NumberRoom.NARROW) {
        NumberNow(text, unit, "\n", Modifier.fillMaxWidth())
        slider()
        Row(horizontalArrangement = Arrangement.spacedBy(8.dp)) {
            less()
            more()
        }
        return
    }
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp), Alignment.CenterVertically) {
        less()
        NumberNow(text, unit, " ", Modifier.weight(1f))
        more()
    }
    slider()
}

/** The number with its unit after [between]. */
@Composable
private fun NumberNow(text: String, unit: String, between: String, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    val size = if (text.length > LONG) NUMBER_SIZE_LONG else NUMBER_SIZE
    Text(
        buildAnnotatedString {
            append(text)
            if (unit.isNotEmpty()) {
                append(between)
                withStyle(SpanStyle(colours.quiet, UNIT_SIZE.sp)) { append(unit) }
            }
        },
        modifier.testTag(ProgramTags.NUMBER_NOW).announced(),
        TextStyle(fontSize = size.sp, fontWeight = FontWeight.Medium),
        textAlign = TextAlign.Center,
    )
}

@Composable
private fun NumberSlider(now: Double, scale: NumberScale, scope: BlockScope, onPut: (Double) -> Unit) {
    val label = BlockTexts.number(spoken)
    val range = scale.min.toFloat()..scale.max.toFloat()
    Slider(
        now.toFloat().coerceIn(range),
        SliderWords(label, scope.shownNumber(written(now)), ProgramTags.NUMBER_SLIDER),
        Modifier.fillMaxWidth(),
        range,
    ) { onPut(round(it / scale.step) * scale.step) }
}

/** Whether the line turns the robot to the left, so that the dial shows the angle to that side. */
private fun isLeft(part: PhrasePart.Value, scope: BlockScope): Boolean =
    scope.state.program.lineAt(part.span.start).parts.any {
        it is PhrasePart.Choice && scope.inEnglish(scope.textOf(it)).equals("left", ignoreCase = true)
    }

private val DEFAULT_SCALE = NumberScale(0.0, 100.0, 1.0)

/** Repeated steps shall not add up rounding errors. */
private const val SMALLEST = 0.001
private val DIAL = 168.dp
private val KEY = 60.dp
private val ROOMY = 440.dp
private val BETWEEN = 16.dp

/** The least width of the number beside the pad, for text of the default size. */
private val LEAST = 100.dp
private const val MOST_SCALE = 1.5f
private val WIDEST = 320.dp

/** From this width on the number stands between its buttons. */
private val FOR_STEPPER = 220.dp

/** The same where the number may take two lines. */
private val FOR_LOW_STEPPER = 172.dp
private const val NUMBER_SIZE = 28
private const val NUMBER_SIZE_LONG = 20
private const val LONG = 6
private const val UNIT_SIZE = 15
