package robotran.world.robot

import robotran.brick.kind.BrickKind
import robotran.brick.kind.ByBrick
import robotran.world.Drive
import robotran.world.MicrobitMotorParameters
import robotran.world.NxtMotorParameters
import robotran.world.Penbot

/**
 * How robots are built around a kind of brick.
 *
 * @property seatWidth what the brick covers in pictures from its left to its right, in centimetres.
 * @property seatLength the same from its upper to its lower end.
 * @property rightBumperPort the port on which a bumper is usually the right one; on port 1 it is the left one.
 * @property hasShortForm whether its penbot is described by what is on each port, see
 * [PortSensor][robotran.world.PortSensor].
 */
class BrickBuild internal constructor(
    internal val seatWidth: Double,
    internal val seatLength: Double,
    internal val rightBumperPort: Int,
    val hasShortForm: Boolean,
    internal val motor: DriveMotor,
) {
    companion object {
        /** 6.4 by 11.2 cm, a little smaller in pictures. */
        private fun ofRcx() = BrickBuild(
            seatWidth = 6.1,
            seatLength = 9.8,
            rightBumperPort = 3,
            hasShortForm = true,
            RcxMotor,
        )

        /** 7.2 by 11.2 cm, a little smaller in pictures. */
        private fun ofNxt() = BrickBuild(
            seatWidth = 6.6,
            seatLength = 10.2,
            rightBumperPort = 2,
            hasShortForm = false,
            NxtMotor,
        )

        /** 5.2 by 4.3 cm, drawn as if it lay on the buggy. */
        private fun ofMicrobit() = BrickBuild(
            seatWidth = 5.0,
            seatLength = 4.2,
            rightBumperPort = 2,
            hasShortForm = false,
            MicrobitMotor,
        )

        private fun hub(seatWidth: Double, seatLength: Double) =
            BrickBuild(seatWidth, seatLength, rightBumperPort = 2, hasShortForm = false, NxtMotor)

        private val BUILDS = ByBrick { brick ->
            when (brick) {
                BrickKind.RCX -> ofRcx()
                BrickKind.NXT, BrickKind.NXT_PYBRICKS -> ofNxt()

                // 5.6 by 8.8 cm, with the plugs at its sides.
                BrickKind.SPIKE_PRIME -> hub(seatWidth = 6.2, seatLength = 8.6)

                // 4 by 5.6 cm.
                BrickKind.SPIKE_ESSENTIAL -> hub(seatWidth = 4.0, seatLength = 5.6)

                // 4.8 by 7.2 cm, with the plugs at its sides.
                BrickKind.TECHNIC_HUB -> hub(seatWidth = 6.2, seatLength = 7.2)

                // 7.2 by 11.2 cm.
                BrickKind.EV3 -> hub(seatWidth = 6.8, seatLength = 10.4)

                BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> ofMicrobit()
            }
        }

        fun of(brick: BrickKind): BrickBuild = BUILDS[brick]
    }
}

/** The motor of a drive wheel. Units are those of [RobotParameters]. */
internal interface DriveMotor {
    val lag: Double

    fun topSpeed(drive: Drive, circumference: Double): Double

    /** At which timed statements drive; on a brick with counters, at which a pilot drives by itself. */
    fun calibratedSpeed(drive: Drive, circumference: Double): Double

    fun stallForce(drive: Drive): Double

    fun rollingDeceleration(drive: Drive, circumference: Double): Double
}

private object RcxMotor : DriveMotor {
    /** At 9 V in N cm, and the part of it that the gears leave. */
    private const val STALL_TORQUE = 6.0
    private const val GEAR_EFFICIENCY = 0.85

    private const val SECONDS_PER_MINUTE = 60.0

    override val lag = Penbot.MOTOR_LAG

    override fun topSpeed(drive: Drive, circumference: Double) =
        Penbot.MOTOR_NO_LOAD_SPEED / drive.gear / SECONDS_PER_MINUTE * circumference

    override fun calibratedSpeed(drive: Drive, circumference: Double) =
        topSpeed(drive, circumference) * (Penbot.CALIBRATED_SPEED / Penbot.TOP_SPEED)

    override fun stallForce(drive: Drive) =
        STALL_TORQUE * drive.gear * GEAR_EFFICIENCY / (drive.wheelDiameter / 2) * NEWTON

    override fun rollingDeceleration(drive: Drive, circumference: Double) = Penbot.ROLLING_DECELERATION
}

private object NxtMotor : DriveMotor {
    private const val FULL_TURN = 360.0

    override val lag = NxtMotorParameters.LAG

    override fun topSpeed(drive: Drive, circumference: Double) =
        NxtMotorParameters.FREE_SPEED / drive.gear / FULL_TURN * circumference

    override fun calibratedSpeed(drive: Drive, circumference: Double) =
        NxtMotorParameters.PILOT_SPEED / drive.gear / FULL_TURN * circumference

    override fun stallForce(drive: Drive) = NxtMotorParameters.STALL_TORQUE * drive.gear *
        NxtMotorParameters.GEAR_EFFICIENCY / (drive.wheelDiameter / 2) * NEWTON

    override fun rollingDeceleration(drive: Drive, circumference: Double) =
        NxtMotorParameters.ROLLING_DECELERATION / drive.gear / FULL_TURN * circumference
}

/**
 * A motor of a micro:bit buggy. Nobody has published measured speeds of one: these are start values, which pupils replace by
 * their own, see [MicrobitMotorParameters].
 */
private object MicrobitMotor : DriveMotor {
    override val lag = MicrobitMotorParameters.LAG

    override fun topSpeed(drive: Drive, circumference: Double) = MicrobitMotorParameters.TOP_SPEED / drive.gear

    override fun calibratedSpeed(drive: Drive, circumference: Double) =
        MicrobitMotorParameters.CALIBRATED_SPEED / drive.gear

    override fun stallForce(drive: Drive) =
        MicrobitMotorParameters.STALL_TORQUE * drive.gear / (drive.wheelDiameter / 2) * NEWTON

    override fun rollingDeceleration(drive: Drive, circumference: Double) = Penbot.ROLLING_DECELERATION
}

/** In kg cm/s2. */
private const val NEWTON = 100.0
