package robotran.ui.runbar

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.toggleable
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.scale
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*

/** Turns all sound on or off: a loudspeaker with waves, or crossed out. */
@Composable
fun SoundSwitch(on: Boolean, onSwitch: (Boolean) -> Unit, modifier: Modifier = Modifier) {
    val name = RunTexts.sound(spoken)
    val word = if (on) RunTexts.soundOn(spoken) else RunTexts.soundOff(spoken)
    val colours = LocalRobotranColours.current
    Box(
        modifier
            .testTag(RunTags.SOUND)
            .focusRing()
            .toggleable(on, role = Role.Switch, onValueChange = onSwitch)
            .semantics {
                contentDescription = name
                stateDescription = word
            }
            .size(Dimensions.TARGET),
        Alignment.Center,
    ) {
        Canvas(Modifier.size(24.dp)) {
            scale(size.width / ICON_UNITS, Offset.Zero) {
                drawLoudspeaker(on, if (on) colours.onPane else colours.quiet)
            }
        }
    }
}

/** Drawn on a square of [ICON_UNITS]. */
private fun DrawScope.drawLoudspeaker(on: Boolean, colour: Color) {
    val cone = Path().apply {
        moveTo(3f, 9f)
        lineTo(7f, 9f)
        lineTo(12f, 4f)
        lineTo(12f, 20f)
        lineTo(7f, 15f)
        lineTo(3f, 15f)
        close()
    }
    drawPath(cone, colour)
    if (on) {
        for (radius in listOf(4f, 8f)) {
            drawArc(
                colour,
                -45f,
                90f,
                false,
                Offset(12f - radius, 12f - radius),
                Size(2 * radius, 2 * radius),
                style = LINE,
            )
        }
    } else {
        drawLine(colour, Offset(16f, 9f), Offset(22f, 15f), LINE.width, StrokeCap.Round)
        drawLine(colour, Offset(22f, 9f), Offset(16f, 15f), LINE.width, StrokeCap.Round)
    }
}

private const val ICON_UNITS = 24f
private val LINE = Stroke(2f, cap = StrokeCap.Round)
