package robotran.ui.sheet

import androidx.compose.ui.unit.dp
import robotran.world.Template
import kotlin.math.max

internal fun templateOutline(template: Template, transform: SheetTransform) =
    Outline(template.strokes.map { Outline.Polyline(it.map(transform::toPixels)) })

/** A faint dotted line for the pen to trace; it stays visible in small pictures. */
internal fun DrawTarget.drawTemplate(outline: Outline, transform: SheetTransform) {
    val width = max(TEMPLATE_CENTIMETRES * transform.pixelsPerCentimetre, MIN_WIDTH * dp)
    // Dashes of zero length with round ends are dots.
    shape(outline, edge = SheetColours.TEMPLATE, line = Line.round(width, 0f to 2 * width))
}

private const val TEMPLATE_CENTIMETRES = 0.5f

/** In dp. */
private const val MIN_WIDTH = 2.2f
