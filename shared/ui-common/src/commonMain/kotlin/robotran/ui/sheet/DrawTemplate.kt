package robotran.ui.sheet

import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.world.Template
import kotlin.math.max

fun templatePath(template: Template, transform: SheetTransform): Path = Path().apply {
    for (stroke in template.strokes) addLine(stroke.map { transform.toPixels(it.x, it.y) })
}

/** A faint dotted line for the pen to trace; it stays visible in small pictures. */
internal fun DrawScope.drawTemplate(path: Path, transform: SheetTransform) {
    val width = max(TEMPLATE_CENTIMETRES * transform.pixelsPerCentimetre, MIN_WIDTH.toPx())
    // Dashes of zero length with round ends are dots.
    val dots = PathEffect.dashPathEffect(floatArrayOf(0f, 2 * width))
    drawPath(
        path,
        SheetColours.TEMPLATE,
        style = Stroke(width, cap = StrokeCap.Round, join = StrokeJoin.Round, pathEffect = dots),
    )
}

private const val TEMPLATE_CENTIMETRES = 0.5f
private val MIN_WIDTH = 2.2.dp
