package robotran.uikit

import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** How far something is, from 0 to 1. */
@Composable
fun Progress(
    part: () -> Float,
    modifier: Modifier = Modifier,
    color: Color = RobotranColours.RUN_GREEN,
    ground: Color = LocalRobotranColours.current.line,
    gap: Dp = 0.dp,
) = LinearProgressIndicator(part, modifier, color, ground, gapSize = gap, drawStopIndicator = { })
