package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.robolang.robot.RobotTarget

/** Drives like the class `Pilot` of a translation, in the same 32-bit decimals. */
internal class NxtPilot(private val robot: RobotTarget.Nxt, private val motors: NxtMotors) {
    private val degreesPerCentimetre: Float = sign * FULL_TURN / (PI * robot.wheelDiameter.toFloat())
    private val degreesPerDegree: Float = sign * robot.track.toFloat() / robot.wheelDiameter.toFloat()
    private val left: MotorPort = robot.left
    private val right: MotorPort = robot.right
    private var leftGoal = 0f
    private var rightGoal = 0f

    val isMoving: Boolean get() = motors.isMoving(left) || motors.isMoving(right)

    /** Of the degrees that a motor turns to drive its wheel forwards. */
    private val sign: Int get() = if (robot.isReversed) -1 else 1

    fun travel(distance: Float, sourceLine: Int) =
        turnWheels(distance * degreesPerCentimetre, distance * degreesPerCentimetre, sourceLine)

    /** To the left; a minus is to the right. */
    fun rotate(angle: Float, sourceLine: Int) =
        turnWheels(-angle * degreesPerDegree, angle * degreesPerDegree, sourceLine)

    fun run(leftForward: Boolean, rightForward: Boolean, sourceLine: Int) {
        motors.run(left, leftForward != robot.isReversed, sourceLine)
        motors.run(right, rightForward != robot.isReversed, sourceLine)
    }

    fun stop(sourceLine: Int) {
        motors.stop(left, sourceLine)
        motors.stop(right, sourceLine)
    }

    /** Stops what is still on its way. */
    fun cutShort(sourceLine: Int) {
        if (motors.isMoving(left)) motors.stop(left, sourceLine)
        if (motors.isMoving(right)) motors.stop(right, sourceLine)
    }

    private fun turnWheels(leftDegrees: Float, rightDegrees: Float, sourceLine: Int) {
        leftGoal = goal(left, leftGoal) + leftDegrees
        rightGoal = goal(right, rightGoal) + rightDegrees
        motors.rotateTo(left, rounded(leftGoal), sourceLine)
        motors.rotateTo(right, rounded(rightGoal), sourceLine)
    }

    /** What is left of a degree counts only if the wheel is where the last move ended. */
    private fun goal(motor: MotorPort, last: Float): Float {
        val position = motors.position(motor)
        val difference = position - last
        return if (difference > 1 || difference < -1) position.toFloat() else last
    }

    /** `Math.round(goal)`, also of infinite numbers. */
    private fun rounded(goal: Float): Int = if (goal <= Int.MIN_VALUE.toFloat()) Int.MIN_VALUE else roundToWhole(goal)

    private companion object {
        const val FULL_TURN = 360
        const val PI = 3.1415927f
    }
}
