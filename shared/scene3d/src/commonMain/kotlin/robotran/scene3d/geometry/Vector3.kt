package robotran.scene3d.geometry

import kotlin.math.sqrt

/**
 * A point or a direction in space, in centimetres: x and y as on the paper, z upwards from it.
 */
data class Vector3(val x: Double, val y: Double, val z: Double) {
    operator fun plus(other: Vector3) = Vector3(x + other.x, y + other.y, z + other.z)

    operator fun minus(other: Vector3) = Vector3(x - other.x, y - other.y, z - other.z)

    operator fun times(factor: Double) = Vector3(x * factor, y * factor, z * factor)

    fun dot(other: Vector3): Double = x * other.x + y * other.y + z * other.z

    /** Perpendicular to both; seen from its tip, the turn from this vector to [other] is counter-clockwise. */
    fun cross(other: Vector3) = Vector3(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x)

    val length: Double get() = sqrt(dot(this))

    /** The same direction with the length 1; the zero vector stays what it is. */
    val unit: Vector3 get() = length.let { if (it == 0.0) this else this * (1 / it) }
}
