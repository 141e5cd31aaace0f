package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.dp

/** A line between what is above and below. */
@Composable
fun HorizontalDivider(modifier: Modifier = Modifier, color: Color = LocalRobotranColours.current.line) =
    Canvas(modifier.fillMaxWidth().height(THICKNESS)) {
        drawLine(color, Offset(0f, size.height / 2), Offset(size.width, size.height / 2), THICKNESS.toPx())
    }

/** A line between what is at the left and right. */
@Composable
fun VerticalDivider(modifier: Modifier = Modifier, color: Color = LocalRobotranColours.current.line) =
    Canvas(modifier.fillMaxHeight().width(THICKNESS)) {
        drawLine(color, Offset(size.width / 2, 0f), Offset(size.width / 2, size.height), THICKNESS.toPx())
    }

private val THICKNESS = 1.dp
