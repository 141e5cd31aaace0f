package robotran.ui.sheet.svg

import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/**
 * Writes shapes and lines of a sheet that is [paperHeight] high. Rotations are left to the picture's viewer, so nothing
 * is rounded.
 */
internal class SvgShapes(private val svg: SvgWriter, private val paperHeight: Double) {
    /** Converts a y coordinate of the paper to the distance from the picture's top. */
    fun down(y: Double): Double = paperHeight - y

    fun down(points: List<Point>): List<Point> = points.map { Point(it.x, down(it.y)) }

    fun shape(shape: Shape, vararg attributes: Pair<String, Any?>) {
        when (shape) {
            is Shape.Circle -> {
                svg.element(
                    "circle",
                    "cx" to shape.centre.x,
                    "cy" to down(shape.centre.y),
                    "r" to shape.radius,
                    *attributes,
                )
            }

            is Shape.Rectangle -> {
                svg.element(
                    "rect",
                    "x" to shape.centre.x - shape.width / 2,
                    "y" to down(shape.centre.y) - shape.height / 2,
                    "width" to shape.width,
                    "height" to shape.height,
                    "transform" to turned(shape.angle, shape.centre),
                    *attributes,
                )
            }

            is Shape.Polygon -> svg.element("polygon", "points" to parameters(down(shape.corners)), *attributes)
        }
    }

    /** Null for no rotation. */
    fun turned(degrees: Double, centre: Point): String? =
        if (degrees == 0.0) null else "rotate(${figure(-degrees)} ${figure(centre.x)} ${figure(down(centre.y))})"

    /** A line with round ends and joins. */
    fun line(points: List<Point>, closed: Boolean, width: Double, vararg attributes: Pair<String, Any?>) = svg.element(
        if (closed) "polygon" else "polyline",
        "points" to parameters(down(points)),
        "fill" to "none",
        "stroke-width" to width,
        "stroke-linecap" to "round",
        "stroke-linejoin" to "round",
        *attributes,
    )

    /** Text centred on a place, with a paper-coloured outline for contrast. */
    fun label(text: String, point: Point, size: Double) = svg.textElement(
        "text",
        text,
        "x" to point.x,
        "y" to down(point.y),
        "font-size" to size,
        "text-anchor" to "middle",
        "font-weight" to "bold",
        "fill" to hex(SheetColours.LABEL),
        "stroke" to "#ffffff",
        "stroke-width" to size / 6,
        "paint-order" to "stroke",
    )
}
