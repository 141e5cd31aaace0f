package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.regulator.MotorRegulator

/** The motors of an NXT, with the calls of leJOS NXJ's `NXTRegulatedMotor`, which remembers the speed of each. */
internal class NxtMotors(private val nxt: Nxt) {
    private val speeds = FloatArray(MotorPort.entries.size) { NxtConstants.speedOf(NxtConstants.FIRST_POWER).toFloat() }
    private val isControlled = BooleanArray(MotorPort.entries.size)

    /** `forward()` and `backward()`. */
    fun run(motor: MotorPort, isForward: Boolean, sourceLine: Int) {
        val limit = if (isForward) MotorRegulator.FORWARD else MotorRegulator.BACKWARD
        begin(motor, speeds[motor.ordinal], limit, sourceLine)
    }

    /** `rotateTo(limit, true)`. */
    fun rotateTo(motor: MotorPort, limit: Int, sourceLine: Int) = begin(motor, speeds[motor.ordinal], limit, sourceLine)

    /** `stop(true)`. */
    fun stop(motor: MotorPort, sourceLine: Int) {
        if (!isControlled[motor.ordinal] || isMoving(motor)) begin(motor, 0f, MotorRegulator.FORWARD, sourceLine)
    }

    /** `flt(true)`. */
    fun roll(motor: MotorPort, sourceLine: Int) {
        isControlled[motor.ordinal] = false
        nxt.call(NxtCall.of(NxtNative.REGULATOR_ROLL, motor.ordinal), sourceLine)
    }

    /** `setSpeed(speed)`. */
    fun setSpeed(motor: MotorPort, speed: Int, sourceLine: Int) {
        speeds[motor.ordinal] = speed.toFloat()
        if (isMoving(motor)) nxt.call(NxtCall.regulatorSpeed(motor.ordinal, speed.toFloat()), sourceLine)
    }

    /** `resetTachoCount()` of a motor that stands. */
    fun reset(motor: MotorPort, sourceLine: Int) {
        nxt.call(NxtCall.of(NxtNative.RESET_TACHO_COUNT, motor.ordinal), sourceLine)
    }

    fun isMoving(motor: MotorPort): Boolean = nxt.regulator(motor.ordinal).isMoving

    /** `getPosition()`: the degrees where the motor should be now. */
    fun position(motor: MotorPort): Int = roundToWhole(nxt.regulator(motor.ordinal).position)

    fun turned(motor: MotorPort): Int = nxt.tachoCount(motor.ordinal)

    private fun begin(motor: MotorPort, speed: Float, limit: Int, sourceLine: Int) {
        isControlled[motor.ordinal] = true
        val acceleration = NxtConstants.ACCELERATION
        nxt.call(NxtCall.regulate(motor.ordinal, speed, acceleration, limit, hold = true), sourceLine)
    }
}
