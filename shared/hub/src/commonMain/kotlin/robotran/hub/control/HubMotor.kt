package robotran.hub.control

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.hub.model.HubMotorKind
import robotran.hub.model.HubPort
import robotran.hub.program.HubMotorView
import kotlin.math.abs
import kotlin.math.floor

/**
 * A port for a motor, and the controller behind it. What is plugged in turns as its environment says, and is told a power
 * by [state].
 */
internal class HubMotor(val port: HubPort) : HubMotorView {
    private val meter = TurnMeter()
    private val axis = AxisControl(stiffness = 1.0, tolerance = 0.0)
    private var sign = 1
    private var zero = 0.0

    /** What is plugged in; null if it is no motor. */
    var plugged: HubMotorKind? = null

    /** Whether the program has made it. */
    var isMade = false
        private set

    /** The driving base that it is part of. */
    var base: DriveBase? = null

    /** What the port tells the motor; the same object until that changes. */
    var state = MotorState(checkNotNull(port.motorPort), MotorMode.FLOAT, power = 0)
        private set

    /** The same in the program's direction, as its angle; the same object until that changes. */
    var shownState = state
        private set

    override var commands = 0
        private set

    val kind: HubMotorKind get() = plugged ?: HubMotorKind.MEDIUM

    /** Where it is in the program's direction and count, degrees. */
    val exactAngle: Double get() = sign * meter.degrees - zero
    val exactSpeed: Double get() = sign * meter.speed
    val meanSpeed: Double get() = sign * meter.meanSpeed

    /** Degrees since the beginning of time, clockwise positive. */
    val turned: Double get() = meter.degrees

    override val angle: Int get() = floor(exactAngle + HALF).toInt()
    override val speed: Int get() = meanSpeed.toInt()
    override val isDone: Boolean get() = base?.takeIf { it.isActive }?.isDone ?: axis.isDone
    override val isStalled: Boolean get() = axis.isStalled

    /** Whether a move of it goes on, or it turns without end. */
    val isOnItsWay: Boolean get() = base?.takeIf { it.isActive }?.isOnItsWay ?: axis.isOnItsWay

    /** Whether a move or a hold keeps it. */
    val isControlled: Boolean get() = axis.isActive || base?.isActive == true

    /** Sets how far it has turned since the beginning of time. */
    fun turnTo(degrees: Double) {
        meter.degrees = degrees
    }

    /** Makes it for a program. An angular motor counts from its mark, others from 0. */
    fun make(isReversed: Boolean) {
        isMade = true
        sign = if (isReversed) -1 else 1
        axis.fit(kind.freeSpeed, kind.angleTolerance.toDouble())
        val turned = sign * meter.degrees
        zero = if (kind.hasMark) FULL_TURN * floor((turned + FULL_TURN / 2) / FULL_TURN) else turned
    }

    /** Forgets the program. */
    fun reset() {
        isMade = false
        base = null
        axis.leave()
        coast()
    }

    fun run(speed: Int) {
        command()
        axis.follow(Trajectory.endless(from(), fromSpeed(), limited(speed).toDouble(), ACCELERATION))
    }

    /** @param speed 0 or more is towards [degrees] above 0. */
    fun runBy(speed: Int, degrees: Int) {
        val way = if (speed < 0) -degrees else degrees
        runTo(speed, from() + way)
    }

    fun runTo(speed: Int, target: Double) {
        val start = from()
        val before = fromSpeed()
        command()
        val fastest = abs(limited(speed)).coerceAtLeast(1).toDouble()
        axis.follow(Trajectory.to(target, start, before, fastest, ACCELERATION))
    }

    fun hold() {
        command()
        axis.hold(exactAngle)
    }

    fun stop() {
        command()
        axis.leave()
        coast()
    }

    fun brake() {
        command()
        axis.leave()
        tell(MotorMode.BRAKE, power = 0)
    }

    /** Counts on from [angle]. A move that goes on keeps its way. */
    fun resetAngle(angle: Int) {
        if (isControlled) stop()
        zero = sign * meter.degrees - angle
    }

    /** Another controls it from now on. */
    fun giveUp() {
        commands++
        axis.leave()
    }

    /** Measures; call it every [ControlConstants.PERIOD] milliseconds. */
    fun sample() = meter.sample()

    /** Controls; call it after [sample]. */
    fun tick() {
        if (axis.isActive) drive(axis.tick(exactAngle, exactSpeed, meanSpeed))
    }

    /** @param power percent in the program's direction. */
    fun drive(power: Double) {
        val rounded = floor(sign * power + HALF).toInt()
        val mode = if (rounded > 0) {
            MotorMode.FORWARD
        } else if (rounded < 0) {
            MotorMode.BACKWARD
        } else {
            MotorMode.BRAKE
        }
        tell(mode, abs(rounded))
    }

    fun coast() = tell(MotorMode.FLOAT, power = 0)

    fun brakeOnly() = tell(MotorMode.BRAKE, power = 0)

    private fun command() {
        base?.interrupt(this)
        commands++
    }

    private fun from(): Double = axis.reference ?: exactAngle

    private fun fromSpeed(): Double = if (axis.reference == null) exactSpeed else axis.referenceSpeed

    private fun limited(speed: Int) = speed.coerceIn(-kind.highestSpeed, kind.highestSpeed)

    private fun tell(mode: MotorMode, power: Int) {
        if (state.mode != mode || state.power != power) {
            state = state.copy(mode = mode, power = power, brakesInPauses = true)
            shownState = if (sign < 0) state.copy(mode = mode.reversed) else state
        }
    }

    private companion object {
        const val HALF = 0.5
        const val FULL_TURN = 360.0
        const val ACCELERATION = HubMotorKind.ACCELERATION.toDouble()
    }
}

private val MotorMode.reversed: MotorMode
    get() = when (this) {
        MotorMode.FORWARD -> MotorMode.BACKWARD
        MotorMode.BACKWARD -> MotorMode.FORWARD
        MotorMode.BRAKE, MotorMode.FLOAT -> this
    }
