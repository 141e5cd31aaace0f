package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.ScreenPoint
import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.SceneElement
import robotran.scene3d.model.SceneNode

/**
 * What a picture shows at a pixel.
 *
 * @property point where on its surface.
 */
class SceneHit(val element: SceneElement, val point: Vector3)

/** The nearest element of [scene] at the pixel [position]; null if only paper, desk or sky is there. */
fun elementAt(scene: Scene, projection: Projection, position: ScreenPoint): SceneHit? {
    val (solid, point) = solidAt(scene, projection, position) ?: return null
    return solid.element?.let { SceneHit(it, point) }
}

/** The nearest solid at a pixel and the point of its surface, by a ray through all of them. */
internal fun solidAt(scene: Scene, projection: Projection, position: ScreenPoint): Pair<SceneNode.Solid, Vector3>? {
    val eye = projection.view.eye
    val ray = projection.rayThrough(position)
    val least = Projection.NEAR / ray.dot(projection.view.forward)
    val nearest = solids(scene.root).mapNotNull { solid -> entry(solid, eye, ray)?.let { it to solid } }
        .filter { (share, _) -> share >= least }
        .minByOrNull { (share, _) -> share } ?: return null
    return nearest.second to eye + ray * nearest.first
}

private fun solids(node: SceneNode): Sequence<SceneNode.Solid> = when (node) {
    is SceneNode.Solid -> sequenceOf(node)
    is SceneNode.Group -> node.parts.asSequence().flatMap { solids(it) }
    is SceneNode.Stack -> node.levels.asSequence().flatMap { solids(it) }
}

/** How many times [ray] must be added to [eye] to enter a solid; null if it misses it. */
private fun entry(solid: SceneNode.Solid, eye: Vector3, ray: Vector3): Double? {
    val from = solid.place.inside(eye)
    val way = solid.place.turnedInside(ray)
    var enter = 0.0
    var leave = Double.MAX_VALUE
    for (face in solid.body.faces) {
        val distance = face.distanceTo(from)
        val speed = face.normal.dot(way)
        if (speed == 0.0) {
            if (distance > 0) return null
            continue
        }
        val share = -distance / speed
        if (speed < 0) enter = maxOf(enter, share) else leave = minOf(leave, share)
        if (enter > leave) return null
    }
    return enter.takeIf { it > 0 }
}
