package robotran.robotediting

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorCase
import robotran.brick.sensors.SensorKind
import robotran.world.Facing
import robotran.world.SensorPart
import robotran.world.geometry.Direction
import robotran.world.geometry.Point

/**
 * The body of a sensor from above, relative to its eye, in centimetres. What looks down is drawn as if it looked ahead.
 *
 * @property back how far it reaches behind the eye.
 * @property front how far it reaches ahead of the eye.
 * @property half of its width.
 */
data class SensorBody(val back: Double, val front: Double, val half: Double) {
    /** With [margin] centimetres more on every side. */
    fun grown(margin: Double) = SensorBody(back + margin, front + margin, half + margin)

    /** The corners of that of [part] on the robot. */
    fun corners(part: SensorPart): List<Point> {
        val direction = Direction((part.facing as? Facing.Ahead)?.direction ?: 0.0)
        return listOf(-back to -half, front to -half, front to half, -back to half)
            .map { (along, across) -> direction.from(part.at, along, across) }
    }

    companion object {
        private val STUDDED = SensorBody(0.4, 0.8, 0.8)

        /** What looks nowhere, or whose eyes nobody sees. */
        private val INSIDE = setOf(
            SensorKind.COMPASS,
            SensorKind.GYRO,
            SensorKind.MINDSENSORS_COMPASS,
            SensorKind.HITECHNIC_ACCELERATION,
            SensorKind.MINDSENSORS_ACCELERATION,
            SensorKind.RCX_LINK,
            SensorKind.INFRARED_SEEKER,
            SensorKind.INFRARED_SEEKER_2,
        )

        fun of(sensor: SensorKind, brick: BrickKind): SensorBody = when (sensor) {
            SensorKind.ULTRASONIC -> SensorBody(1.8, 0.0, 2.3)
            SensorKind.SOUND -> SensorBody(2.0, 0.0, 1.2)
            SensorKind.OPTICAL_DISTANCE -> SensorBody(1.4, 0.0, 2.2)
            SensorKind.RCX_LIGHT -> STUDDED
            in INSIDE -> SensorBody(1.2, 1.2, 1.2)
            else -> when (brick.sensorCase) {
                SensorCase.STUDDED -> STUDDED
                SensorCase.ROUNDED -> SensorBody(0.9, 0.9, 0.7)
            }
        }
    }
}
