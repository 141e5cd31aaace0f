package robotran.scene3d.camera

import robotran.scene3d.geometry.Vector3
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry

/**
 * Where a camera is and how it is turned. The three directions have the length 1 and are perpendicular; the camera is
 * never tilted to a side, so [right] is horizontal.
 *
 * @property eye in centimetres; above the paper.
 * @property forward where it looks.
 * @property up upwards in the picture.
 * @property ahead [forward] without its height, with the length 1.
 */
class ViewPoint private constructor(
    val eye: Vector3,
    val forward: Vector3,
    val right: Vector3,
    val up: Vector3,
    val ahead: Vector3,
) {
    companion object {
        /**
         * A camera at [eye] that looks in the direction [heading], in degrees counter-clockwise from the x axis, and
         * [pitch] degrees downwards, -89..89.
         */
        fun looking(eye: Vector3, heading: Double, pitch: Double, trigonometry: Trigonometry): ViewPoint {
            val cosine = trigonometry.cosine(heading * RADIANS_PER_DEGREE)
            val sine = trigonometry.sine(heading * RADIANS_PER_DEGREE)
            val level = trigonometry.cosine(pitch * RADIANS_PER_DEGREE)
            val down = trigonometry.sine(pitch * RADIANS_PER_DEGREE)
            return ViewPoint(
                eye,
                Vector3(cosine * level, sine * level, -down),
                Vector3(sine, -cosine, 0.0),
                Vector3(cosine * down, sine * down, level),
                Vector3(cosine, sine, 0.0),
            )
        }

        /** The same at [distance] from [target], which is then in the middle of the picture. */
        fun around(
            target: Vector3,
            heading: Double,
            pitch: Double,
            distance: Double,
            trigonometry: Trigonometry,
        ): ViewPoint {
            val turned = looking(target, heading, pitch, trigonometry)
            return ViewPoint(target - turned.forward * distance, turned.forward, turned.right, turned.up, turned.ahead)
        }
    }
}
