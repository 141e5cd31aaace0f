package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.size
import androidx.compose.material3.LocalContentColor
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.scale
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** The icons of run controls on a square of 24 units: [solid] polygons and lines as [strokes]. */
enum class RunIcon(val solid: List<List<Float>> = emptyList(), val strokes: List<List<Float>> = emptyList()) {
    PLAY(solid = listOf(listOf(6f, 3f, 21f, 12f, 6f, 21f))),
    PAUSE(solid = listOf(listOf(5f, 4f, 10f, 4f, 10f, 20f, 5f, 20f), listOf(14f, 4f, 19f, 4f, 19f, 20f, 14f, 20f))),
    STOP(solid = listOf(listOf(4f, 4f, 20f, 4f, 20f, 20f, 4f, 20f))),
    STEP(solid = listOf(listOf(4f, 4f, 14f, 12f, 4f, 20f), listOf(16f, 4f, 20f, 4f, 20f, 20f, 16f, 20f))),
    PREVIOUS(solid = listOf(listOf(19f, 5f, 9f, 12f, 19f, 19f), listOf(5f, 5f, 8f, 5f, 8f, 19f, 5f, 19f))),
    NEXT(solid = listOf(listOf(5f, 5f, 15f, 12f, 5f, 19f), listOf(16f, 5f, 19f, 5f, 19f, 19f, 16f, 19f))),
    DOWN(strokes = listOf(listOf(6f, 9f, 12f, 15f, 18f, 9f))),
    UP(strokes = listOf(listOf(6f, 15f, 12f, 9f, 18f, 15f))),
    CLOSE(strokes = listOf(listOf(6f, 6f, 18f, 18f), listOf(18f, 6f, 6f, 18f))),
    DONE(strokes = listOf(listOf(4f, 13f, 10f, 19f, 20f, 6f))),
    OPEN(strokes = listOf(listOf(12f, 4f, 18f, 6f, 20f, 12f, 18f, 18f, 12f, 20f, 6f, 18f, 4f, 12f, 6f, 6f, 12f, 4f))),
    MORE(strokes = listOf(listOf(12f, 5f, 12f, 19f), listOf(5f, 12f, 19f, 12f))),
    LESS(strokes = listOf(listOf(5f, 12f, 19f, 12f))),

    /** Two panes side by side. */
    TWO(strokes = listOf(listOf(3f, 5f, 21f, 5f, 21f, 19f, 3f, 19f, 3f, 5f), listOf(12f, 5f, 12f, 19f))),

    /** Two sliders. */
    SETTINGS(
        solid = listOf(listOf(13f, 4f, 18f, 4f, 18f, 10f, 13f, 10f), listOf(6f, 14f, 11f, 14f, 11f, 20f, 6f, 20f)),
        strokes = listOf(listOf(3f, 7f, 21f, 7f), listOf(3f, 17f, 21f, 17f)),
    ),
}

/** [icon] in [colour]; the caller provides the accessibility text. */
@Composable
fun RunIconView(
    icon: RunIcon,
    modifier: Modifier = Modifier,
    side: Dp = 20.dp,
    colour: Color = LocalContentColor.current,
) {
    Canvas(modifier.size(side)) { scale(size.width / UNITS, Offset.Zero) { drawRunIcon(icon, colour) } }
}

/** Drawn on a square of [UNITS]. */
private fun DrawScope.drawRunIcon(icon: RunIcon, colour: Color) {
    for (corners in icon.solid) drawPath(pathOf(corners).apply { close() }, colour)
    for (corners in icon.strokes) drawPath(pathOf(corners), colour, style = LINE)
}

private fun pathOf(corners: List<Float>): Path = Path().apply {
    moveTo(corners[0], corners[1])
    for (corner in 2..<corners.size step 2) lineTo(corners[corner], corners[corner + 1])
}

private val LINE = Stroke(2.6f, cap = StrokeCap.Round, join = StrokeJoin.Round)
private const val UNITS = 24f
