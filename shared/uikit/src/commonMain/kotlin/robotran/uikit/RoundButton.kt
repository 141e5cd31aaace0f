package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** The strokes of an icon, as start and end points relative to its size. */
typealias StrokeIcon = List<Pair<Offset, Offset>>

val Cross: StrokeIcon = listOf(Offset(0f, 0f) to Offset(1f, 1f), Offset(0f, 1f) to Offset(1f, 0f))
val Plus: StrokeIcon = listOf(Offset(0.5f, 0f) to Offset(0.5f, 1f), Offset(0f, 0.5f) to Offset(1f, 0.5f))

/** A button of the given [size] with a [sign]; [label] is its accessibility text. */
@Composable
fun RoundButton(
    sign: StrokeIcon,
    label: String,
    tag: String,
    size: Dp = 14.dp,
    enabled: Boolean = true,
    onClick: () -> Unit,
) {
    val colour = LocalRobotranColours.current.onPane.let { if (enabled) it else it.copy(alpha = DISABLED) }
    Box(
        Modifier
            .testTag(tag)
            .size(Dimensions.TARGET)
            .clip(CircleShape)
            .focusRing()
            .clickable(enabled, role = Role.Button, onClick = onClick)
            .semantics { contentDescription = label },
        Alignment.Center,
    ) {
        SignPicture(sign, colour, size)
    }
}

/** A [sign] without a button. */
@Composable
fun SignPicture(sign: StrokeIcon, colour: Color, size: Dp) = Canvas(Modifier.size(size)) { drawSign(sign, colour) }

private fun DrawScope.drawSign(sign: StrokeIcon, colour: Color) {
    for ((from, to) in sign) {
        drawLine(colour, from.on(size), to.on(size), strokeWidth = 2.dp.toPx(), cap = StrokeCap.Round)
    }
}

private fun Offset.on(size: Size) = Offset(x * size.width, y * size.height)

/** Material's alpha of disabled elements. */
private const val DISABLED = 0.38f
