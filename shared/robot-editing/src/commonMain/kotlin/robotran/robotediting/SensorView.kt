package robotran.robotediting

import robotran.brick.sensors.SensorKind
import robotran.world.Facing
import robotran.world.Light
import robotran.world.OpticalDistance
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.Sonar
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.robot.things

/** What a sensor of a robot sees or hears. Places are on the robot, or on the paper after [on]. */
sealed interface SensorView {
    /** The index of the sensor in [things]. */
    val number: Int

    /** The same for a robot at [pose], on its paper. */
    fun on(pose: Pose): SensorView

    /** A place on the paper below it. */
    data class Spot(override val number: Int, val at: Point, val radius: Double) : SensorView {
        override fun on(pose: Pose) = copy(at = at.on(pose))
    }

    /**
     * What is ahead.
     *
     * @property direction its middle, in degrees counter-clockwise.
     * @property degrees its width.
     * @property reach in centimetres.
     * @property isSound whether an ultrasonic sensor listens there.
     */
    data class Cone(
        override val number: Int,
        val eye: Point,
        val direction: Double,
        val degrees: Double,
        val reach: Double,
        val isSound: Boolean,
    ) : SensorView {
        override fun on(pose: Pose) = copy(eye = eye.on(pose), direction = direction + pose.heading)

        /** The rays of an ultrasonic sensor, as angles; for others the two edges. */
        val rays: List<Double>
            get() {
                val step = if (isSound) Sonar.RAY_STEP else degrees
                return List((degrees / step).toInt() + 1) { direction - degrees / 2 + it * step }
            }
    }
}

/** What the robot's sensors see; bumpers and sensors of the robot's own state see nothing. */
fun RobotDescription.views(): List<SensorView> =
    things.mapIndexedNotNull { number, part -> (part as? SensorPart)?.let { viewOf(number, it) } }

private fun viewOf(number: Int, part: SensorPart): SensorView? = when {
    part.sensor.seesSurfaces -> when (val facing = part.facing) {
        Facing.Down, Facing.Free -> SensorView.Spot(number, part.at, SPOT_RADIUS)

        is Facing.Ahead -> SensorView.Cone(
            number,
            part.at,
            facing.direction,
            LIGHT_DEGREES,
            Light.MAX_ECHO_DISTANCE,
            isSound = false,
        )
    }

    part.sensor == SensorKind.ULTRASONIC -> SensorView.Cone(
        number,
        part.at,
        (part.facing as? Facing.Ahead)?.direction ?: 0.0,
        2 * Sonar.BEAM,
        Sonar.SURE,
        isSound = true,
    )

    part.sensor == SensorKind.OPTICAL_DISTANCE -> SensorView.Cone(
        number,
        part.at,
        (part.facing as? Facing.Ahead)?.direction ?: 0.0,
        OpticalDistance.BEAM,
        OpticalDistance.FARTHEST,
        isSound = false,
    )

    else -> null
}

private fun Point.on(pose: Pose): Point = Direction(pose.heading).from(Point(pose.x, pose.y), x, y)

/** Roughly the area that a light sensor averages, in centimetres. */
private const val SPOT_RADIUS = 0.6
private const val LIGHT_DEGREES = 60.0
