package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon

/** A part of a scene. Parts nest, so that each has few neighbours to be ordered with. */
sealed interface SceneNode {
    /** What it covers of the paper, in the world's coordinates. */
    val footprint: ConvexPolygon

    /** One convex body. */
    class Solid(val body: Body, val place: Placement, val element: SceneElement?) : SceneNode {
        override val footprint: ConvexPolygon =
            body.footprint.placed(place.x, place.y, place.cosine, place.sine)
    }

    /** Parts side by side: their footprints have no inner point in common. */
    class Group(override val footprint: ConvexPolygon, val parts: List<SceneNode>) : SceneNode

    /**
     * Parts on top of each other.
     *
     * @property levels from bottom to top.
     * @property heights of the horizontal planes between them, in centimetres above the paper; one less than levels.
     */
    class Stack(override val footprint: ConvexPolygon, val levels: List<SceneNode>, val heights: List<Double>) :
        SceneNode
}

/** Where a body stands: moved by [x], [y] and [z], turned by the angle with this [cosine] and [sine]. */
class Placement(
    val x: Double = 0.0,
    val y: Double = 0.0,
    val z: Double = 0.0,
    val cosine: Double = 1.0,
    val sine: Double = 0.0,
) {
    /** The same, [height] higher. */
    fun raised(height: Double) = Placement(x, y, z + height, cosine, sine)

    /** The same, moved along its own axes. */
    fun shifted(forwards: Double, leftwards: Double = 0.0, upwards: Double = 0.0) = Placement(
        x + forwards * cosine - leftwards * sine,
        y + forwards * sine + leftwards * cosine,
        z + upwards,
        cosine,
        sine,
    )

    /** This place on something that stands at [other]. */
    fun on(other: Placement): Placement = other.shifted(x, y, z).let {
        Placement(
            it.x,
            it.y,
            it.z,
            other.cosine * cosine - other.sine * sine,
            other.sine * cosine + other.cosine * sine,
        )
    }

    companion object {
        val ORIGIN = Placement()
    }
}

/** An element of the world that a scene shows; its number counts those of its kind in the world. */
data class SceneElement(val kind: SceneElementKind, val number: Int)

enum class SceneElementKind { WALL, BARRIER, BLOCK, ROBOT, LAMP, FLAG }
