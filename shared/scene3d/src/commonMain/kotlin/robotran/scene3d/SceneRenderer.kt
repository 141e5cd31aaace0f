package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.SpaceTransform
import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.Face
import robotran.scene3d.model.Placement
import robotran.scene3d.model.SceneElement
import robotran.scene3d.model.SceneNode
import robotran.scene3d.model.shaded
import robotran.scene3d.order.drawingOrder
import kotlin.math.sqrt

/**
 * A polygon of a picture.
 *
 * @property points its corners in pixels, x and y in turn; at least three.
 * @property colour as 0xAARRGGBB, with all light and shade.
 * @property isSide whether it is a flat side of a body, whose edges are the body's; not a part of a round side, nor
 * something on a side.
 */
class DrawnPolygon internal constructor(
    val points: FloatArray,
    val colour: Int,
    val isSide: Boolean,
    internal val solid: SceneNode.Solid,
) {
    /** What it belongs to; null for nothing of the world. */
    val element: SceneElement? get() = solid.element
}

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
            is SceneNode.Solid -> {
                draw(node)
            }

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
        val scale = projection.scaleAt(Vector3(place.x, place.y, place.z))
        for (face in solid.body.faces) {
            if (face.hidden || face.distanceTo(eye) <= 0) continue
            val points = transform.polygon(face.corners, projection) ?: continue
            val brightness = if (face.glows) 1.0 else brightness(face, light)
            if (face.smooth) spread(points)
            polygons += DrawnPolygon(points, shaded(face.colour, brightness), !face.smooth, solid)
            for (decal in face.decals) {
                if (decal.fine && scale < FINE_SCALE) continue
                val shape = transform.polygon(decal.corners, projection) ?: continue
                polygons += DrawnPolygon(shape, shaded(decal.colour, if (decal.glows) 1.0 else brightness), false, solid)
            }
        }
    }

    private fun brightness(face: Face, light: Vector3) = DARKEST + (1 + face.normal.dot(light)) / 2 * LIT

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

        /** The direction to the room's lamp: from the upper left, a little in front. */
        val LIGHT = Vector3(-0.45, -0.32, 0.84).unit
        const val DARKEST = 0.46
        const val LIT = 0.58
    }
}

/** [point] in the coordinates of a body at this place. */
internal fun Placement.inside(point: Vector3): Vector3 = turnedInside(Vector3(point.x - x, point.y - y, point.z - z))

internal fun Placement.turnedInside(way: Vector3) =
    Vector3(way.x * cosine + way.y * sine, way.y * cosine - way.x * sine, way.z)
