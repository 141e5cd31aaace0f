package robotran.ui.program.blocks.sheets

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.width
import androidx.compose.material3.Slider
import androidx.compose.material3.SliderDefaults
import androidx.compose.material3.Text
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
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.NumberScale
import robotran.blockediting.scale
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ValueUse
import robotran.ui.program.blocks.BlockScope
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_less
import robotran.ui.resources.blocks_more_of
import robotran.ui.resources.blocks_number
import robotran.ui.theme.LocalRobotranColours
import robotran.worldediting.written
import kotlin.math.round

/**
 * The number at [part]: buttons for a little less and more, a slider or a dial, and a number pad. Everything changes
 * the program at once, and is undone together when the sheet has closed.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun NumberEditor(part: PhrasePart.Value, scope: BlockScope, onClose: () -> Unit) {
    var entered by remember { mutableStateOf(TypedNumber(null)) }
    // On the sheet of paper, the number is changed without typing.
    val typed = entered.takeIf { it.number == null || it.number == scope.textOf(part) } ?: TypedNumber(null)
    val focus = remember { FocusRequester() }
    val scale = part.use.scale ?: DEFAULT_SCALE
    val now = scope.numberIn(part)
    val put = { number: Double ->
        entered = TypedNumber(null)
        if (number != now) scope.put(written(number))
    }
    val step = { by: Double -> put(round(((now ?: 0.0) + by) / SMALLEST) * SMALLEST) }
    val type = { next: TypedNumber ->
        entered = next
        next.number?.takeIf { it != scope.textOf(part) }?.let { scope.put(it) }
        Unit
    }
    val preview = previewWords(part, scope)
    val keys = NumberKeys(typed, scope.textOf(part), type, { step(it * scale.step) }, onClose)
    LaunchedEffect(Unit) { focus.requestFocus() }
    Column(
        Modifier
            .fillMaxWidth()
            .onPreviewKeyEvent(keys::handle)
            .focusRequester(focus)
            .focusable()
            .testTag("number")
            .semantics { preview?.let { stateDescription = it } },
        Arrangement.spacedBy(8.dp),
    ) {
        Stepper(typed.text ?: scope.textOf(part), part.use.unit.orEmpty(), { step(-scale.step) }, { step(scale.step) })
        FlowRow(
            Modifier.fillMaxWidth(),
            Arrangement.spacedBy(16.dp, Alignment.CenterHorizontally),
            Arrangement.spacedBy(8.dp),
        ) {
            if (part.use == ValueUse.ANGLE) {
                AngleDial(now ?: 0.0, isLeft(part, scope), put)
            } else {
                NumberSlider(now ?: scale.min, scale, put)
            }
            NumberPad { sign -> type(typed.with(sign, scope.textOf(part))) }
        }
    }
}

@Composable
private fun Stepper(text: String, unit: String, onLess: () -> Unit, onMore: () -> Unit) = Row(
    Modifier.fillMaxWidth(),
    Arrangement.spacedBy(8.dp, Alignment.CenterHorizontally),
    Alignment.CenterVertically,
) {
    SheetButton("−", "number-less", spoken = stringResource(Res.string.blocks_less), onClick = onLess)
    Text(
        if (unit.isEmpty()) text else "$text $unit",
        Modifier.weight(1f).testTag("number-now").semantics { liveRegion = LiveRegionMode.Polite },
        color = LocalRobotranColours.current.onPane,
        fontSize = NUMBER_SIZE.sp,
        textAlign = TextAlign.Center,
    )
    SheetButton("+", "number-more", spoken = stringResource(Res.string.blocks_more_of), onClick = onMore)
}

@Composable
private fun NumberSlider(now: Double, scale: NumberScale, onPut: (Double) -> Unit) {
    val colours = LocalRobotranColours.current
    val label = stringResource(Res.string.blocks_number)
    val range = scale.min.toFloat()..scale.max.toFloat()
    Slider(
        now.toFloat().coerceIn(range),
        { onPut(round(it / scale.step) * scale.step) },
        Modifier.width(SLIDER_WIDTH).testTag("number-slider").semantics {
            contentDescription = label
            stateDescription = written(now)
        },
        valueRange = range,
        colors = SliderDefaults.colors(
            thumbColor = colours.onPane,
            activeTrackColor = colours.onPane,
            inactiveTrackColor = colours.line,
        ),
    )
}

/** Whether the line turns the robot to the left, so that the dial shows the angle to that side. */
private fun isLeft(part: PhrasePart.Value, scope: BlockScope): Boolean =
    scope.state.program.lineAt(part.span.start).parts.any {
        it is PhrasePart.Choice && scope.textOf(it).equals("left", ignoreCase = true)
    }

private val DEFAULT_SCALE = NumberScale(0.0, 100.0, 1.0)

/** Repeated steps shall not add up rounding errors. */
private const val SMALLEST = 0.001
private val SLIDER_WIDTH = 240.dp
private const val NUMBER_SIZE = 28
