package robotran.scene3d.camera

import robotran.scene3d.geometry.Vector3

/**
 * An affine map from the coordinates of a solid to those of a camera: to the right, upwards, and away from it. Made
 * once per solid and frame, so that each corner needs one map only.
 */
class SpaceTransform private constructor(private val rows: DoubleArray) {
    /**
     * The polygon with these [corners], x, y and z in turn, in pixels of [projection]; null if nothing of it is in the
     * picture.
     */
    fun polygon(corners: DoubleArray, projection: Projection): FloatArray? {
        val count = corners.size / AXES
        val seen = DoubleArray(corners.size)
        var nearCorners = 0
        for (corner in 0 until count) {
            val from = corner * AXES
            val x = corners[from]
            val y = corners[from + 1]
            val z = corners[from + 2]
            for (axis in 0 until AXES) {
                val row = axis * ROW
                seen[from + axis] = rows[row] * x + rows[row + 1] * y + rows[row + 2] * z + rows[row + 3]
            }
            if (seen[from + 2] < Projection.NEAR) nearCorners++
        }
        return when (nearCorners) {
            0 -> toPixels(seen, projection)
            count -> null
            else -> toPixels(cutNear(seen), projection)
        }
    }

    /** Where the point [x], [y], [z] of a solid is in the picture; null if it is not in front of the camera. */
    fun toScreen(x: Double, y: Double, z: Double, projection: Projection): ScreenPoint? {
        fun along(axis: Int): Double =
            rows[axis * ROW] * x + rows[axis * ROW + 1] * y + rows[axis * ROW + 2] * z + rows[axis * ROW + 3]
        val depth = along(2)
        if (depth < Projection.NEAR) return null
        return ScreenPoint(
            projection.centre.x + projection.focal * along(0) / depth,
            projection.centre.y - projection.focal * along(1) / depth,
        )
    }

    /** The pixels of a centimetre at the nearest of these [corners]. */
    fun nearestScale(corners: DoubleArray, projection: Projection): Double {
        var nearest = Double.MAX_VALUE
        for (from in corners.indices step AXES) {
            val row = 2 * ROW
            val depth = rows[row] * corners[from] + rows[row + 1] * corners[from + 1] +
                rows[row + 2] * corners[from + 2] + rows[row + 3]
            nearest = minOf(nearest, depth)
        }
        return projection.focal / maxOf(nearest, Projection.NEAR)
    }

    private fun toPixels(seen: DoubleArray, projection: Projection): FloatArray? {
        val pixels = FloatArray(seen.size / AXES * 2)
        var left = Float.MAX_VALUE
        var right = -Float.MAX_VALUE
        var top = Float.MAX_VALUE
        var bottom = -Float.MAX_VALUE
        for (corner in 0 until seen.size / AXES) {
            val scale = projection.focal / seen[corner * AXES + 2]
            val x = (projection.centre.x + scale * seen[corner * AXES]).toFloat()
            val y = (projection.centre.y - scale * seen[corner * AXES + 1]).toFloat()
            pixels[2 * corner] = x
            pixels[2 * corner + 1] = y
            left = minOf(left, x)
            right = maxOf(right, x)
            top = minOf(top, y)
            bottom = maxOf(bottom, y)
        }
        val isOutside = right < 0 || bottom < 0 || left > projection.size.width || top > projection.size.height
        return if (isOutside) null else pixels
    }

    /** Sutherland and Hodgman's clipping, at one plane. */
    private fun cutNear(seen: DoubleArray): DoubleArray {
        val count = seen.size / AXES
        val kept = DoubleArray((count + count) * AXES)
        var size = 0
        for (corner in 0 until count) {
            val here = corner * AXES
            val next = (corner + 1) % count * AXES
            val depth = seen[here + 2]
            val nextDepth = seen[next + 2]
            if (depth >= Projection.NEAR) {
                for (axis in 0 until AXES) kept[size++] = seen[here + axis]
            }
            if ((depth >= Projection.NEAR) != (nextDepth >= Projection.NEAR)) {
                val share = (Projection.NEAR - depth) / (nextDepth - depth)
                for (axis in 0 until AXES) {
                    kept[size++] = seen[here + axis] + share * (seen[next + axis] - seen[here + axis])
                }
            }
        }
        return kept.copyOf(size)
    }

    companion object {
        private const val AXES = 3
        private const val ROW = 4

        /** For solids in the world's own coordinates. */
        fun of(view: ViewPoint): SpaceTransform = of(view, 0.0, 0.0, 0.0, 1.0, 0.0)

        /**
         * For a solid that is turned about its upright axis by the angle with this [cosine] and [sine], then moved to
         * [x], [y], [z].
         */
        fun of(view: ViewPoint, x: Double, y: Double, z: Double, cosine: Double, sine: Double): SpaceTransform {
            val way = Vector3(x, y, z) - view.eye
            val rows = DoubleArray(AXES * ROW)
            listOf(view.right, view.up, view.forward).forEachIndexed { axis, direction ->
                rows[axis * ROW] = direction.x * cosine + direction.y * sine
                rows[axis * ROW + 1] = direction.y * cosine - direction.x * sine
                rows[axis * ROW + 2] = direction.z
                rows[axis * ROW + 3] = direction.dot(way)
            }
            return SpaceTransform(rows)
        }
    }
}
