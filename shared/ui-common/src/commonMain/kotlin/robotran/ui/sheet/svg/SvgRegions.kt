package robotran.ui.sheet.svg

import robotran.ui.sheet.GoalRegion
import robotran.ui.sheet.SeamlessPolygon
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.colour
import robotran.ui.sheet.roomiestPoint
import robotran.uikit.*
import robotran.world.RegionRole
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.math.min

/** Writes the regions of goals, with a flag on each target. */
internal class SvgRegions(private val svg: SvgWriter, private val shapes: SvgShapes) {
    fun region(region: GoalRegion, met: Boolean) {
        val (colour, dashes) = when (region.role) {
            RegionRole.TARGET -> SheetColours.REACH to null
            RegionRole.FORBIDDEN -> SheetColours.STAY_OUT to "0.9 0.9"
            RegionRole.PERMITTED -> SheetColours.STAY_IN to "2.4 0.9"
        }
        val fill = when {
            region.role == RegionRole.PERMITTED -> null
            met -> MET_OPACITY
            else -> OPACITY
        }
        val inside = arrayOf("fill" to if (fill == null) "none" else hex(colour), "fill-opacity" to fill)
        val edge = arrayOf("stroke" to hex(colour), "stroke-width" to REGION_LINE, "stroke-dasharray" to dashes)
        val polygon = (region.shape as? Shape.Polygon)?.let(SeamlessPolygon::of)
        val pieces = polygon?.outline
        if (pieces == null) {
            shapes.shape(region.shape, *inside, *edge)
        } else {
            shapes.shape(Shape.Polygon(polygon.corners), *inside)
            for (piece in pieces) {
                svg.element(
                    "polyline",
                    "points" to parameters(shapes.down(piece)),
                    "fill" to "none",
                    *edge,
                )
            }
        }
        if (region.role == RegionRole.TARGET) flag(region)
    }

    private fun flag(region: GoalRegion) {
        val (place, room) = roomiestPoint(region.shape)
        val size = min(room * 2 * FLAG_PART, MAX_FLAG)
        val cell = size / 5
        val left = place.x - size * if (region.number == null) 0.4 else 0.65
        val top = shapes.down(place.y) - size / 2
        svg.element("g", "fill" to hex(SheetColours.FLAG)) {
            svg.element("rect", "x" to left - size / 28, "y" to top, "width" to size / 14, "height" to size)
            svg.element("rect", "x" to left, "y" to top, "width" to 4 * cell, "height" to 3 * cell, "fill" to "#ffffff")
            for (row in 0 until FLAG_ROWS) {
                for (column in row % 2 until FLAG_COLUMNS step 2) {
                    svg.element(
                        "rect",
                        "x" to left + column * cell,
                        "y" to top + row * cell,
                        "width" to cell,
                        "height" to cell,
                    )
                }
            }
        }
        region.number?.let {
            shapes.label(it.toString(), Point(place.x + size * 0.55, place.y - size * 0.28), size * 0.8)
        }
    }

    private companion object {
        const val REGION_LINE = 0.3
        const val OPACITY = 0.1
        const val MET_OPACITY = 0.35
        const val FLAG_PART = 0.45
        const val MAX_FLAG = 6.0
        const val FLAG_ROWS = 3
        const val FLAG_COLUMNS = 4
    }
}
