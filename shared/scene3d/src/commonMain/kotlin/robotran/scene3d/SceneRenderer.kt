package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.SpaceTransform
import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.Placement
import robotran.scene3d.model.SceneElement
import robotran.scene3d.model.SceneNode
import robotran.scene3d.model.shaded
import robotran.scene3d.order.drawingOrder
import kotlin.math.sqrt

/**
 * Something to be filled with one colour, or with shades of it.
 *
 * @property contours polygons in pixels, x and y in turn; at least one with three corners. They do not overlap.
 * @property colour as 0xAARRGGBB, with all light and shade.
 * @property shading how the colour changes from one side to the other; null if it does not.
 * @property isSide whether it is a flat side of a body, whose edges are the body's; not a part of a round side, nor
 * something on a side.
 */
class DrawnPolygon internal constructor(
    val contours: List<FloatArray>,
    val colour: Int,
    val shading: Shading?,
    val isSide: Boolean,
    internal val solid: SceneNode.Solid,
) {
    /** What it belongs to; null for nothing of the world. */
    val element: SceneElement? get() = solid.element
}

/**
 * A change of colours along the line from one pixel to another.
 *
 * @property parts of the way at which there are [colours], from 0 to 1 in order.
 */
class Shading(
    val fromX: Float,
    val fromY: Float,
    val toX: Float,
    val toY: Float,
    val parts: FloatArray,
    val colours: IntArray,
)

/**
 * The polygons of [scene] from back to front: drawn in this order, each covers what is behind it.
 *
 * Levels are drawn from the farthest from the camera to its own, parts side by side in the order of [drawingOrder].
 * A body is convex, so those of its faces that are turned to the camera do not cover each other, and the others are
 * not seen.
 */
fun drawnPolygons(scene: Scene, projection: Projection): List<DrawnPolygon> =
    SceneRenderer(projection).apply { draw(scene.root) }.polygons

private class SceneRenderer(private val projection: Projection) {
    val polygons = ArrayList<DrawnPolygon>()

    fun draw(node: SceneNode) {
        when (node) {
            is SceneNode.Solid -> draw(node)

            is SceneNode.Group -> {
                val order = drawingOrder(node.parts.map { it.footprint }, projection.view)
                for (part in order) draw(node.parts[part])
            }

            is SceneNode.Stack -> {
                val own = node.heights.count { projection.view.eye.z > it }
                for (level in 0 until own) draw(node.levels[level])
                for (level in node.levels.size - 1 downTo own) draw(node.levels[level])
            }
        }
    }

    private fun draw(solid: SceneNode.Solid) {
        val place = solid.place
        val eye = place.inside(projection.view.eye)
        val light = place.turnedInside(LIGHT)
        val transform = SpaceTransform.of(projection.view, place.x, place.y, place.z, place.cosine, place.sine)
        val bands = solid.body.bands
        for (band in bands) {
            BandPainter(band, eye, light, transform, projection).paint()?.let {
                polygons += it.of(solid)
            }
        }
        val inBands = bands.sumOf { it.faces.size }
        for ((number, face) in solid.body.faces.withIndex()) {
            if (face.hidden || face.distanceTo(eye) <= 0) continue
            if (number < inBands) continue
            val points = transform.polygon(face.corners, projection) ?: continue
            val brightness = if (face.glows) 1.0 else brightness(face.normal, light)
            if (face.smooth) spread(points)
            polygons += DrawnPolygon(listOf(points), shaded(face.colour, brightness), null, !face.smooth, solid)
            val isNear = face.decals.isNotEmpty() && transform.nearestScale(face.corners, projection) >= FINE_SCALE
            for (decal in face.decals) {
                if (decal.fine && !isNear) continue
                val shapes = decal.shapes.mapNotNull { transform.polygon(it, projection) }
                if (shapes.isEmpty()) continue
                val colour = shaded(decal.colour, if (decal.glows) 1.0 else brightness)
                polygons += DrawnPolygon(shapes, colour, null, false, solid)
            }
        }
    }

    /** Makes a polygon a little larger, so that no gap shows between two parts of a round side. */
    private fun spread(points: FloatArray) {
        val count = points.size / 2
        var x = 0f
        var y = 0f
        for (corner in 0 until count) {
            x += points[2 * corner] / count
            y += points[2 * corner + 1] / count
        }
        for (corner in 0 until count) {
            val awayX = points[2 * corner] - x
            val awayY = points[2 * corner + 1] - y
            val away = sqrt(awayX * awayX + awayY * awayY)
            if (away == 0f) continue
            points[2 * corner] += awayX / away * OVERLAP
            points[2 * corner + 1] += awayY / away * OVERLAP
        }
    }

    private companion object {
        /** Pixels a centimetre below which small decals are left out. */
        const val FINE_SCALE = 3.2
        const val OVERLAP = 0.45f
    }
}

/** [point] in the coordinates of a body at this place. */
internal fun Placement.inside(point: Vector3): Vector3 = turnedInside(Vector3(point.x - x, point.y - y, point.z - z))

internal fun Placement.turnedInside(way: Vector3) =
    Vector3(way.x * cosine + way.y * sine, way.y * cosine - way.x * sine, way.z)
