package robotran.ui.sheet

import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.SonarDevice
import robotran.simulation.state.RobotSnapshot
import robotran.world.Facing
import robotran.world.Light
import robotran.world.LightFacing
import robotran.world.OpticalDistance
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.box

/** What a sensor that is plugged in sees. */
internal sealed interface Sight {
    /** A place on the paper below it. */
    class Spot(val at: Point) : Sight

    /**
     * What is ahead.
     *
     * @property direction its middle, in degrees counter-clockwise on the sheet.
     * @property degrees its width.
     * @property reach in centimetres.
     * @property isSound whether an ultrasonic sensor listens there.
     * @property heard the distance from which the last echo came; null if there was none.
     */
    class Cone(
        val eye: Point,
        val direction: Double,
        val degrees: Double,
        val reach: Double,
        val isSound: Boolean = false,
        val heard: Double? = null,
    ) : Sight
}

/** Whether the robot has such a sensor on a port. */
fun RobotPlacement.has(kind: SensorKind): Boolean = description.parts.any { it.port != null && it.kind == kind }

/** The sights of the robot of [placement]. */
internal fun sightsOf(placement: RobotPlacement, snapshot: RobotSnapshot): List<Sight> =
    placement.description.parts.filterIsInstance<SensorPart>().filter { it.port != null }.distinctBy { it.on(null) }
        .mapNotNull { sightOf(it, placement, snapshot) }

private fun sightOf(part: SensorPart, placement: RobotPlacement, snapshot: RobotSnapshot): Sight? {
    val robot = snapshot.robot
    val eye = robot.ahead(part.at.x, part.at.y)
    return when {
        part.sensor.seesSurfaces -> {
            when (part.facing) {
                Facing.Down -> Sight.Spot(eye)

                is Facing.Ahead -> {
                    val direction = robot.pose.heading + robot.direction(part)
                    Sight.Cone(eye, direction, LIGHT_DEGREES, Light.MAX_ECHO_DISTANCE)
                }

                // A penbot's looks ahead between its bumpers.
                Facing.Free -> {
                    if (placement.lightFacing == LightFacing.FORWARD) {
                        val front = robot.ahead(placement.description.box.right, part.at.y)
                        Sight.Cone(front, robot.pose.heading, LIGHT_DEGREES, Light.MAX_ECHO_DISTANCE)
                    } else {
                        Sight.Spot(eye)
                    }
                }
            }
        }

        part.sensor == SensorKind.ULTRASONIC -> {
            val heard = heard(part, snapshot)
            val reach = heard?.plus(BEHIND_ECHO) ?: FARTHEST
            val direction = robot.pose.heading + robot.direction(part)
            Sight.Cone(eye, direction, SOUND_DEGREES, reach, isSound = true, heard)
        }

        part.sensor == SensorKind.OPTICAL_DISTANCE -> {
            val direction = robot.pose.heading + robot.direction(part)
            Sight.Cone(eye, direction, OpticalDistance.BEAM, OpticalDistance.FARTHEST)
        }

        else -> null
    }
}

/** What the brick has heard from an ultrasonic sensor last; null if it was nothing. */
private fun heard(part: SensorPart, snapshot: RobotSnapshot): Double? {
    val port = part.port ?: return null
    val distance = snapshot.brick.inputs.getOrNull(port - 1)?.distance ?: return null
    return distance.toDouble().takeIf { it < SonarDevice.NOTHING }
}

private const val LIGHT_DEGREES = 60.0
private const val SOUND_DEGREES = 40.0

/** In centimetres: farther than that, a wall is not heard reliably. */
private const val FARTHEST = 160.0
private const val BEHIND_ECHO = 3.0
