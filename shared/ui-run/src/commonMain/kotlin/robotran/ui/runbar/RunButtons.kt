package robotran.ui.runbar

import androidx.compose.animation.core.Animatable
import androidx.compose.animation.core.LinearOutSlowInEasing
import androidx.compose.animation.core.repeatable
import androidx.compose.animation.core.tween
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*

/** The only primary action. While [pulsing], a few soft rings show where to start, unless motion is reduced. */
@Composable
fun RunButton(pulsing: Boolean, onClick: () -> Unit, modifier: Modifier = Modifier, room: Boolean = true) {
    val ring = remember { Animatable(0f) }
    val isStill = LocalLessMotion.current
    LaunchedEffect(pulsing, isStill) {
        ring.snapTo(0f)
        if (pulsing && !isStill) {
            ring.animateTo(1f, repeatable(Motion.PULSES, tween(Motion.PULSE, easing = LinearOutSlowInEasing)))
            ring.snapTo(0f)
        }
    }
    BarButton(
        RunIcons.PLAY,
        BarWords(RunTexts.run(spoken), RunTexts.runHelp(spoken)),
        RunTags.RUN,
        modifier.drawBehind { drawPulse(ring.value) }.defaultMinSize(minWidth = if (room) MIN_RUN_WIDTH else 0.dp),
        if (LocalRunIsNext.current) ButtonKind.RUN else ButtonKind.RUN_OTHER,
        room = room,
        onClick = onClick,
    )
}

/** The width of Run with its label. */
@Composable
internal fun runButtonWidth(): Dp {
    val text = rememberTextMeasurer().measure(
        RunTexts.run(spoken),
        TextStyles.lead.strong.asWritten(),
        maxLines = 1,
    ).size.width
    return maxOf(MIN_RUN_WIDTH, with(LocalDensity.current) { text.toDp() } + RUN_SIGN + BAR_PADDING_WIDTH)
}

/** Ends the program. */
@Composable
fun StopButton(enabled: Boolean, onClick: () -> Unit, modifier: Modifier = Modifier, room: Boolean = true) = BarButton(
    RunIcons.STOP,
    BarWords(RunTexts.stop(spoken), RunTexts.stopHelp(spoken)),
    RunTags.STOP,
    modifier,
    enabled = enabled,
    room = room,
    onClick = onClick,
)

/** Pauses or resumes time. */
@Composable
internal fun PauseButton(
    paused: Boolean,
    enabled: Boolean,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    room: Boolean = true,
) {
    val words = listOf(RunTexts.pause(spoken), RunTexts.goOn(spoken))
    val word = if (paused) words.last() else words.first()
    val help = if (paused) RunTexts.goOnHelp(spoken) else RunTexts.pauseHelp(spoken)
    BarButton(
        if (paused) RunIcons.PLAY else RunIcons.PAUSE,
        BarWords(word, help, words),
        RunTags.PAUSE,
        modifier,
        enabled = enabled,
        room = room,
        onClick = onClick,
    )
}

private fun DrawScope.drawPulse(progress: Float) {
    if (progress <= 0f) return
    val out = 8.dp.toPx() * progress
    drawRoundRect(
        color = RobotranColours.YELLOW.copy(alpha = 0.7f * (1f - progress)),
        topLeft = Offset(-out, -out),
        size = Size(size.width + 2 * out, size.height + 2 * out),
        cornerRadius = CornerRadius(Corners.LARGE.toPx() + out),
    )
}

private val MIN_RUN_WIDTH = 104.dp

/** Its icon with the gap to the label. */
private val RUN_SIGN = 26.dp
private val BAR_PADDING_WIDTH = 32.dp
