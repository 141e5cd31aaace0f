package robotran.simulation.robot

import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.noise.WheelNoise
import robotran.world.NxtMotorParameters
import robotran.world.Penbot
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.robot.RobotParameters

/** The three motors of a robot with an NXT: those of its wheels, and one that moves its pen or a turret, or nothing. */
internal class NxtMotors(
    private val robot: RobotDescription,
    private val parameters: RobotParameters,
    private val streams: NoiseStreams,
    private val realism: Double,
) {
    private val turrets = robot.parts.mapNotNull { (it as? SensorPart)?.turret }
    private val hasTurret = turrets.isNotEmpty()
    private val degreesOfCentimetre =
        robot.drive.gear * FULL_TURN / parameters.wheelCircumference * (if (robot.drive.reversed) -1 else 1)

    val left = NxtMotor(parameters)
    val right = NxtMotor(parameters)

    /** The port of [third]; null if the brick has no port for one. */
    val thirdPort = (listOfNotNull(robot.pen?.motor) + turrets + robot.brick.motorPorts)
        .firstOrNull { it != robot.drive.left && it != robot.drive.right }

    /** The motor that drives no wheel. */
    val third = thirdMotor()

    /** 0 at the pen's upper end stop, 1 at the lower; 0 without a pen. */
    val penDepth: Double
        get() = if (robot.pen == null) {
            0.0
        } else {
            (third.degrees - NxtMotorParameters.PEN_TOP) / (NxtMotorParameters.PEN_BOTTOM - NxtMotorParameters.PEN_TOP)
        }

    val penIsDown: Boolean get() = penDepth >= Penbot.PEN_CONTACT

    /** Degrees that the turret has turned to the left; 0 without one. */
    val turret: Double get() = if (hasTurret) third.degrees else 0.0

    /** What the motors draw together, in free motors, as much as the brick's fuse lets through. */
    val currents: Double get() = minOf(NxtRealism.MAX_CURRENT, left.current + right.current + third.current)

    /** Degrees that the motor of a wheel has turned which has rolled [centimetres]. */
    fun degreesOf(centimetres: Double): Double = centimetres * degreesOfCentimetre

    /**
     * The play between motor and wheel; null in an ideal world.
     *
     * @param side such as `left wheel`; names its stream.
     */
    fun play(side: String): MotorPlay? {
        if (realism == 0.0) return null
        val degrees = NxtRealism.LEAST_PLAY + (NxtRealism.MOST_PLAY - NxtRealism.LEAST_PLAY) *
            streams.named("$side: play").share()
        return MotorPlay(realism * degrees / FULL_TURN / robot.drive.gear * parameters.wheelCircumference)
    }

    private fun thirdMotor(): SmallMotor {
        val noise = WheelNoise(streams, "motor $thirdPort", realism)
        return when {
            robot.pen != null -> SmallMotor(noise, NxtMotorParameters.PEN_TOP, NxtMotorParameters.PEN_BOTTOM)
            hasTurret -> SmallMotor(noise, -NxtMotorParameters.TURRET_END, NxtMotorParameters.TURRET_END)
            else -> SmallMotor(noise, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
        }
    }

    private companion object {
        const val FULL_TURN = 360.0
    }
}
