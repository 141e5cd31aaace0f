package robotran.ui.runbar

import androidx.compose.animation.core.Animatable
import androidx.compose.animation.core.LinearOutSlowInEasing
import androidx.compose.animation.core.repeatable
import androidx.compose.animation.core.tween
import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.LocalContentColor
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.run
import robotran.ui.resources.run_help
import robotran.ui.resources.stop
import robotran.ui.resources.stop_help
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.ui.theme.focusRing

/** The one primary action. While [pulsing], a few soft rings show where to begin. */
@Composable
internal fun RunButton(pulsing: Boolean, onClick: () -> Unit, modifier: Modifier = Modifier) {
    val ring = remember { Animatable(0f) }
    LaunchedEffect(pulsing) {
        ring.snapTo(0f)
        if (pulsing) {
            ring.animateTo(1f, repeatable(PULSES, tween(PULSE_MILLISECONDS, easing = LinearOutSlowInEasing)))
            ring.snapTo(0f)
        }
    }
    val help = stringResource(Res.string.run_help)
    Button(
        onClick = onClick,
        modifier = modifier
            .testTag("run")
            .semantics { onClick(label = help, action = null) }
            .drawBehind { drawPulse(ring.value) }
            .focusRing(CORNER)
            .defaultMinSize(minWidth = 112.dp, minHeight = HEIGHT),
        shape = RoundedCornerShape(CORNER),
        colors = ButtonDefaults.buttonColors(RobotranColours.YELLOW, RobotranColours.ON_YELLOW),
        contentPadding = PADDING,
    ) {
        ButtonContent(Res.string.run) { path -> path.triangle(size) }
    }
}

/** Ends the program. */
@Composable
internal fun StopButton(enabled: Boolean, onClick: () -> Unit, modifier: Modifier = Modifier) {
    val help = stringResource(Res.string.stop_help)
    val colours = LocalRobotranColours.current
    OutlinedButton(
        onClick = onClick,
        enabled = enabled,
        modifier = modifier
            .testTag("stop")
            .semantics { onClick(label = help, action = null) }
            .focusRing(CORNER)
            .defaultMinSize(minWidth = 104.dp, minHeight = HEIGHT),
        shape = RoundedCornerShape(CORNER),
        colors = ButtonDefaults.outlinedButtonColors(
            contentColor = colours.onPane,
            disabledContentColor = colours.quiet.copy(alpha = 0.6f),
        ),
        border = BorderStroke(if (enabled) 2.dp else 1.dp, if (enabled) colours.onPane else colours.line),
        contentPadding = PADDING,
    ) {
        ButtonContent(Res.string.stop) { path -> path.square(size) }
    }
}

@Composable
private fun ButtonContent(name: StringResource, shape: DrawScope.(Path) -> Unit) {
    val colour = LocalContentColor.current
    Canvas(Modifier.size(16.dp)) { drawPath(Path().also { shape(it) }, colour) }
    Text(stringResource(name), Modifier.padding(start = 10.dp), fontSize = 18.sp, fontWeight = FontWeight.SemiBold, maxLines = 1)
}

private fun Path.triangle(size: Size) {
    lineTo(size.width, size.height / 2)
    lineTo(0f, size.height)
    close()
}

private fun Path.square(size: Size) {
    lineTo(size.width, 0f)
    lineTo(size.width, size.height)
    lineTo(0f, size.height)
    close()
}

private fun DrawScope.drawPulse(progress: Float) {
    if (progress <= 0f) return
    val out = 8.dp.toPx() * progress
    drawRoundRect(
        color = RobotranColours.YELLOW.copy(alpha = 0.7f * (1f - progress)),
        topLeft = Offset(-out, -out),
        size = Size(size.width + 2 * out, size.height + 2 * out),
        cornerRadius = CornerRadius(CORNER.toPx() + out),
    )
}

private val CORNER = 16.dp
private val HEIGHT = 56.dp
private val PADDING = PaddingValues(horizontal = 16.dp)

/** The rings end by themselves: nothing on the screen moves for ever. */
private const val PULSES = 5
private const val PULSE_MILLISECONDS = 1400
