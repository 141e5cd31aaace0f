package robotran.hub.control

import robotran.hub.model.HubMotorKind
import robotran.hub.program.DriveBaseSettings
import robotran.hub.program.HubDriveBaseView
import kotlin.math.PI
import kotlin.math.abs

/**
 * Two motors that drive a robot. What they have in common is its way, what they differ by is its heading, both in degrees
 * of the motors.
 *
 * @param wheel diameter of the wheels, thousandths of a millimetre.
 * @param track from wheel to wheel, the same.
 */
internal class DriveBase(private val left: HubMotor, private val right: HubMotor, wheel: Int, track: Int) :
    HubDriveBaseView {
    private val way = AxisControl(HALF, ControlConstants.BASE_TOLERANCE)
    private val heading = AxisControl(HALF, ControlConstants.BASE_TOLERANCE)
    private val scale = BaseScale(wheel, track, minOf(left.kind.highestSpeed, right.kind.highestSpeed))
    private val wayZero = (left.exactAngle + right.exactAngle) / 2
    private val headingZero = (left.exactAngle - right.exactAngle) / 2
    private var straightSpeed = scale.straightSpeed
    private var turnSpeed = scale.turnSpeed

    override var settings: DriveBaseSettings = scale.defaults
        private set

    override var commands = 0
        private set

    /** Whether it controls its motors. */
    val isActive: Boolean get() = way.isActive

    /** Whether a drive goes on. */
    val isOnItsWay: Boolean get() = way.isOnItsWay || heading.isOnItsWay

    private val exactWay: Double get() = (left.exactAngle + right.exactAngle) / 2 - wayZero
    private val exactHeading: Double get() = (left.exactAngle - right.exactAngle) / 2 - headingZero

    override val distance: Int get() = (exactWay / scale.degreesOfMillimetre).toInt()
    override val angle: Double get() = exactHeading / scale.degreesOfDegree
    override val speed: Int get() = ((left.meanSpeed + right.meanSpeed) / 2 / scale.degreesOfMillimetre).toInt()
    override val turnRate: Int get() = ((left.meanSpeed - right.meanSpeed) / 2 / scale.degreesOfDegree).toInt()
    override val straightLimit: Int get() = scale.straightLimit
    override val turnLimit: Int get() = scale.turnLimit
    override val isDone: Boolean get() = way.isDone && heading.isDone
    override val isStalled: Boolean get() = way.isStalled || heading.isStalled

    init {
        val free = minOf(left.kind.freeSpeed, right.kind.freeSpeed)
        way.fit(free, ControlConstants.BASE_TOLERANCE)
        heading.fit(free, ControlConstants.BASE_TOLERANCE)
        left.base = this
        right.base = this
    }

    /** Sets the speeds of moves. The sign is dropped; false if one is 0 or above its limit. */
    fun set(straight: Int, turn: Int): Boolean {
        val (mm, degrees) = abs(straight) to abs(turn)
        if (mm !in 1..scale.straightLimit || degrees !in 1..scale.turnLimit) return false
        straightSpeed = mm * scale.degreesOfMillimetre
        turnSpeed = degrees * scale.degreesOfDegree
        settings = settings.copy(straightSpeed = mm, turnRate = degrees)
        return true
    }

    fun straight(millimetres: Int) = move(millimetres * scale.degreesOfMillimetre, turn = 0.0)

    fun turn(degrees: Int) = move(straight = 0.0, degrees * scale.degreesOfDegree)

    fun drive(millimetres: Int, degrees: Int) {
        val (straight, turn) = begin()
        val mm = millimetres.coerceIn(-scale.straightLimit, scale.straightLimit)
        val rate = degrees.coerceIn(-scale.turnLimit, scale.turnLimit)
        way.follow(endless(straight, mm * scale.degreesOfMillimetre))
        heading.follow(endless(turn, rate * scale.degreesOfDegree))
    }

    fun stop() {
        end()
        for (motor in listOf(left, right)) motor.coast()
    }

    fun brake() {
        end()
        for (motor in listOf(left, right)) motor.brakeOnly()
    }

    /** One of its motors gets a command of its own: the other coasts. */
    fun interrupt(by: HubMotor) {
        if (!isActive) return
        end()
        (if (by == left) right else left).coast()
    }

    /** Controls; call it after its motors have measured. */
    fun tick() {
        if (!isActive) return
        val straight = way.tick(
            exactWay,
            mean(left.exactSpeed, right.exactSpeed),
            mean(left.meanSpeed, right.meanSpeed),
        )
        val turn =
            heading.tick(exactHeading, mean(left.exactSpeed, -right.exactSpeed), mean(left.meanSpeed, -right.meanSpeed))
        left.drive((straight + turn).coerceIn(-ControlConstants.FULL, ControlConstants.FULL))
        right.drive((straight - turn).coerceIn(-ControlConstants.FULL, ControlConstants.FULL))
    }

    private fun move(straight: Double, turn: Double) {
        val (fromWay, fromHeading) = begin()
        way.follow(bounded(fromWay, straight, straightSpeed, scale.straightAcceleration))
        heading.follow(bounded(fromHeading, turn, turnSpeed, scale.turnAcceleration))
    }

    /** Takes the motors; tells where both begin: where they should be or, if nobody controlled them, where they are. */
    private fun begin(): Pair<Beginning, Beginning> {
        val straight = way.reference?.let { Beginning(it, way.referenceSpeed) }
            ?: Beginning(exactWay, mean(left.exactSpeed, right.exactSpeed))
        val turn = heading.reference?.let { Beginning(it, heading.referenceSpeed) }
            ?: Beginning(exactHeading, mean(left.exactSpeed, -right.exactSpeed))
        left.giveUp()
        right.giveUp()
        commands++
        return straight to turn
    }

    private fun bounded(from: Beginning, by: Double, fastest: Double, acceleration: Double) =
        Trajectory.to(from.angle + by, from.angle, from.speed, fastest, acceleration)

    private fun endless(from: Beginning, speed: Double) =
        Trajectory.endless(from.angle, from.speed, speed, scale.straightAcceleration)

    private fun end() {
        commands++
        way.leave()
        heading.leave()
    }

    private fun mean(one: Double, other: Double) = (one + other) / 2

    private class Beginning(val angle: Double, val speed: Double)

    private companion object {
        const val HALF = 0.5
    }
}

/**
 * What follows from motors, wheels and track, as Pybricks computes it.
 *
 * @param highest the highest speed of the slower motor, degrees a second.
 */
internal class BaseScale(wheel: Int, track: Int, highest: Int) {
    private val millidegreesOfMillimetre = TURN_OVER_PI * THOUSAND / wheel
    private val millidegreesOfDegree = (THOUSAND.toLong() * track / wheel).toInt()

    /** Degrees of a motor for a millimetre. */
    val degreesOfMillimetre: Double = FULL_TURN / PI * THOUSAND / wheel

    /** Degrees of a motor for a degree of the robot. */
    val degreesOfDegree: Double = track.toDouble() / wheel

    /** Degrees of the motors a second. */
    val straightSpeed: Double = highest * STRAIGHT_SHARE / THOUSAND.toDouble()
    val turnSpeed: Double = highest / TURN_SHARE.toDouble()
    val straightAcceleration: Double = ACCELERATION * ACCELERATION_SHARE / THOUSAND.toDouble()
    val turnAcceleration: Double get() = straightAcceleration

    /** The highest that a program may set, mm/s and deg/s. */
    val straightLimit: Int = (THOUSAND * highest.toLong() / millidegreesOfMillimetre).toInt()
    val turnLimit: Int = THOUSAND * highest / millidegreesOfDegree

    val defaults = DriveBaseSettings(
        straightSpeed = (STRAIGHT_SHARE * highest.toLong() / millidegreesOfMillimetre).toInt(),
        straightAcceleration = (ACCELERATION_SHARE * ACCELERATION.toLong() / millidegreesOfMillimetre).toInt(),
        turnRate = THOUSAND * highest / TURN_SHARE / millidegreesOfDegree,
        turnAcceleration = ACCELERATION_SHARE * ACCELERATION / millidegreesOfDegree,
    )

    private companion object {
        const val THOUSAND = 1_000
        const val FULL_TURN = 360.0

        /** Millidegrees of a full turn over pi. */
        const val TURN_OVER_PI = 114_592L
        const val STRAIGHT_SHARE = 400
        const val TURN_SHARE = 3
        const val ACCELERATION = HubMotorKind.ACCELERATION
        const val ACCELERATION_SHARE = 750
    }
}
