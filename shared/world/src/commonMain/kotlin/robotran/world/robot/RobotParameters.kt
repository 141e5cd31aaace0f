package robotran.world.robot

import robotran.brick.controls.MotorPort
import robotran.json.nearestDecimal
import robotran.world.Penbot
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import kotlin.math.PI

/**
 * The figures with which a robot of some construction moves. Lengths are in centimetres, times in milliseconds, speeds
 * in centimetres a second, masses in kilograms, forces in kg cm/s2. For the penbot's construction they are the constants
 * of [Penbot]; its bumpers, sensors and brick do not matter.
 *
 * @property wheelTrack between the middles of the tyres.
 * @property topSpeed of a tyre at full power, with fresh batteries and without load.
 * @property calibratedSpeed of a tyre at [Penbot.CALIBRATED_POWER]; with motors that count, at which a pilot drives by itself.
 * @property motorLag time constant with which a motor starts and brakes.
 * @property stallForce at the tyre that stalls a motor at full power.
 * @property unfeltLoad a load below this is ignored.
 * @property rollingDeceleration of a floating wheel, in cm/s2.
 * @property massX how far the centre of mass is in front of the axle.
 * @property massY how far it is to the left of the middle; always 0.
 * @property inertia about the centre of mass, in kg cm2.
 * @property wheelLoad force of each driven wheel on the paper.
 * @property overallWidth over the tyres, or over the chassis if that is wider.
 * @property millisecondsPerCentimetre how long both motors run at [calibratedSpeed] per centimetre.
 * @property millisecondsPerDegree how long they run so in opposite directions per degree.
 */
class RobotParameters internal constructor(
    val wheelTrack: Double,
    val wheelDiameter: Double,
    val wheelCircumference: Double,
    val wheelWidth: Double,
    val topSpeed: Double,
    val calibratedSpeed: Double,
    val motorLag: Double,
    val stallForce: Double,
    val unfeltLoad: Double,
    val rollingDeceleration: Double,
    val mass: Double,
    val massX: Double,
    val massY: Double,
    val inertia: Double,
    val tyreFriction: Double,
    val wheelLoad: Double,
    val overallWidth: Double,
    val millisecondsPerCentimetre: Double,
    val millisecondsPerDegree: Double,
) {
    companion object {
        /** Of the penbot, read as constants: any formula could round them differently. */
        val PENBOT = RobotParameters(
            wheelTrack = Penbot.WHEEL_TRACK,
            wheelDiameter = Penbot.WHEEL_DIAMETER,
            wheelCircumference = Penbot.WHEEL_CIRCUMFERENCE,
            wheelWidth = Penbot.WHEEL_WIDTH,
            topSpeed = Penbot.TOP_SPEED,
            calibratedSpeed = Penbot.CALIBRATED_SPEED,
            motorLag = Penbot.MOTOR_LAG,
            stallForce = Penbot.STALL_FORCE,
            unfeltLoad = Penbot.UNFELT_LOAD,
            rollingDeceleration = Penbot.ROLLING_DECELERATION,
            mass = Penbot.MASS,
            massX = Penbot.MASS_POSITION,
            massY = 0.0,
            inertia = Penbot.INERTIA,
            tyreFriction = Penbot.TYRE_FRICTION,
            wheelLoad = Penbot.WHEEL_LOAD,
            overallWidth = Penbot.OVERALL_WIDTH,
            millisecondsPerCentimetre = Penbot.MILLISECONDS_PER_CENTIMETRE,
            millisecondsPerDegree = Penbot.MILLISECONDS_PER_DEGREE,
        )

        fun of(robot: RobotDescription): RobotParameters = if (robot.isBuiltAsPenbot) PENBOT else computed(robot)

        /** By the formulas of `docs/robots.md`, for any construction. */
        internal fun computed(robot: RobotDescription): RobotParameters {
            val drive = robot.drive
            val chassis = robot.chassis
            val motor = BrickBuild.of(robot.brick).motor
            val circumference = PI * drive.wheelDiameter
            val width = maxOf(drive.track + drive.wheelWidth, chassis.outline.across)
            val length = chassis.outline.along
            val calibrated = motor.calibratedSpeed(drive, circumference)
            val pace = nearestDecimal(MILLISECONDS_PER_SECOND / calibrated)
            return RobotParameters(
                wheelTrack = drive.track,
                wheelDiameter = drive.wheelDiameter,
                wheelCircumference = circumference,
                wheelWidth = drive.wheelWidth,
                topSpeed = motor.topSpeed(drive, circumference),
                calibratedSpeed = calibrated,
                motorLag = motor.lag,
                stallForce = motor.stallForce(drive),
                unfeltLoad = Penbot.UNFELT_LOAD * (chassis.mass / Penbot.MASS),
                rollingDeceleration = motor.rollingDeceleration(drive, circumference),
                mass = chassis.mass,
                massX = chassis.massAt.x,
                massY = chassis.massAt.y,
                inertia = chassis.mass * (length * length + width * width) / SPREAD,
                tyreFriction = drive.tyreFriction,
                wheelLoad = wheelLoad(robot),
                overallWidth = width,
                millisecondsPerCentimetre = pace,
                millisecondsPerDegree = nearestDecimal(PI * drive.track / FULL_TURN * pace),
            )
        }

        private fun wheelLoad(robot: RobotDescription): Double {
            val weight = robot.chassis.mass * Penbot.GRAVITY
            val mass = robot.chassis.massAt.x
            val caster = robot.supportingCaster ?: return weight / 2
            return weight * (1.0 - mass / caster.x) / 2.0
        }

        private const val MILLISECONDS_PER_SECOND = 1000.0
        private const val FULL_TURN = 360.0

        /** Of the inertia of a mass that is spread evenly over a rectangle. */
        private const val SPREAD = 12.0
    }
}

/** Whether chassis, wheels and casters are the penbot's, whichever motors drive them. */
val RobotDescription.isBuiltAsPenbot: Boolean
    get() {
        val penbot = ReadyRobots.RCX_PENBOT
        val driven = drive.copy(left = MotorPort.A, right = MotorPort.C, reversed = false)
        return brick == penbot.brick && chassis == penbot.chassis && driven == penbot.drive && casters == penbot.casters
    }
