package robotran.scene3d.camera

import robotran.scene3d.geometry.Vector3
import robotran.world.geometry.Point

/** The picture's size in pixels. */
data class PictureSize(val width: Double, val height: Double)

/** A point of the picture, in pixels from its upper left corner. */
data class ScreenPoint(val x: Double, val y: Double)

/**
 * The perspective of a camera: from space to pixels, and back from a pixel to the paper. What is nearer than
 * [NEAR] is cut off, since it would be infinitely large.
 *
 * @property focal the focal length in pixels: what is as far away as it is wide is this wide in the picture.
 * @property centre where [ViewPoint.forward] points to, in pixels.
 * @property size what of the picture can be seen.
 */
class Projection(val view: ViewPoint, val focal: Double, val centre: ScreenPoint, val size: PictureSize) {
    /** The distance of [point] from the camera along its direction, in centimetres. */
    fun depth(point: Vector3): Double = (point - view.eye).dot(view.forward)

    /** The row of pixels in which the paper would vanish if it were endless. */
    val horizon: Double get() = centre.y + focal * view.forward.z / view.up.z

    /** The pixels of a centimetre at [point]; 0 if it is not in front of the camera. */
    fun scaleAt(point: Vector3): Double = depth(point).let { if (it < NEAR) 0.0 else focal / it }

    /** Where [point] is in the picture; null if it is not in front of the camera. */
    fun toScreen(point: Vector3): ScreenPoint? {
        val way = point - view.eye
        val depth = way.dot(view.forward)
        if (depth < NEAR) return null
        return ScreenPoint(
            centre.x + focal * way.dot(view.right) / depth,
            centre.y - focal * way.dot(view.up) / depth,
        )
    }

    /** The direction from the camera through the pixel [position]. */
    fun rayThrough(position: ScreenPoint): Vector3 =
        view.forward * focal + view.right * (position.x - centre.x) + view.up * (centre.y - position.y)

    /** What the pixel [position] shows of the horizontal plane [height] above the paper; null for nothing: the sky. */
    fun onPlane(position: ScreenPoint, height: Double = 0.0): Point? {
        val ray = rayThrough(position)
        val way = height - view.eye.z
        if (way * ray.z <= 0) return null
        val share = way / ray.z
        val point = Point(view.eye.x + share * ray.x, view.eye.y + share * ray.y)
        val isNear = depth(Vector3(point.x, point.y, height)) < FAR
        return if (isNear) point else null
    }

    /**
     * The homography of the paper: from x and y in centimetres to pixels. Row by row; the pixel is the first two of
     * the product with (x, y, 1), divided by the third.
     */
    fun paperMatrix(): DoubleArray {
        val eye = view.eye

        fun row(direction: Vector3) = doubleArrayOf(direction.x, direction.y, -direction.dot(eye))
        val right = row(view.right)
        val up = row(view.up)
        val depth = row(view.forward)
        return DoubleArray(MATRIX) {
            val column = it % ROW
            when (it / ROW) {
                0 -> focal * right[column] + centre.x * depth[column]
                1 -> -focal * up[column] + centre.y * depth[column]
                else -> depth[column]
            }
        }
    }

    /**
     * The polygon with these [corners], x, y and z in turn, as pixels x and y in turn; cut off at [NEAR]. null if
     * nothing of it is in the picture.
     */
    fun polygon(corners: DoubleArray): FloatArray? = SpaceTransform.of(view).polygon(corners, this)

    companion object {
        /** In centimetres: less than the smallest distance of a camera from anything. */
        const val NEAR = 0.5

        /** In centimetres: a touch near the horizon means nothing. */
        const val FAR = 20_000.0
        private const val ROW = 3
        private const val MATRIX = 9
    }
}
