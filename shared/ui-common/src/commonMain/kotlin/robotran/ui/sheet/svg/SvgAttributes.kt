package robotran.ui.sheet.svg

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import robotran.ui.sheet.Line

private typealias Attributes = Array<Pair<String, Any?>>

internal fun place(bounds: Rect): Attributes =
    arrayOf("x" to bounds.left, "y" to bounds.top, "width" to bounds.width, "height" to bounds.height)

internal fun circle(middle: Offset, radius: Float): Attributes =
    arrayOf("cx" to middle.x, "cy" to middle.y, "r" to radius)

internal fun filled(colour: Color?): Attributes = arrayOf(
    "fill" to (colour?.let(::hex) ?: "none"),
    "fill-opacity" to colour?.alpha?.takeIf { it < 1 },
)

/** None without a [colour]. */
internal fun drawn(colour: Color?, line: Line): Attributes = if (colour == null) {
    emptyArray()
} else {
    arrayOf(
        "stroke" to hex(colour),
        "stroke-opacity" to colour.alpha.takeIf { it < 1 },
        "stroke-width" to line.width,
        "stroke-linecap" to "round".takeIf { line.cap == StrokeCap.Round },
        "stroke-linejoin" to "round".takeIf { line.join == StrokeJoin.Round },
        "stroke-dasharray" to line.dashes?.let { (dash, gap) -> "${figure(dash)} ${figure(gap)}" },
    )
}
