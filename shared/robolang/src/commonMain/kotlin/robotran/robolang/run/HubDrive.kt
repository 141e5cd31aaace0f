package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.hub.messages.HubErrorMessages
import robotran.hub.messages.reason
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubCall
import robotran.hub.program.HubNative
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.PowerSide
import kotlin.math.PI
import kotlin.math.floor

/** The wheels of a robot with a hub: together as a driving base or, if their powers differ, each by its motor. */
internal class HubDrive(private val robot: RobotTarget.Hub, private val uses: HubUses, private val calls: HubCalls) {
    private val speeds = MotorPort.entries.associateWith {
        HubConstants.speedOf(HubConstants.FIRST_POWER)
    }.toMutableMap()
    private val base get() = calls.hub.driveBase
    private var move = 0

    /** Drives ahead or back by [ahead] 1 or -1, or turns to the right or left by [turn]. */
    fun start(ahead: Int, turn: Int, sourceLine: Int) {
        if (uses.areWheelsApart) {
            run(robot.left, ahead + turn, sourceLine)
            run(robot.right, ahead - turn, sourceLine)
        } else {
            val speed = speedOf(robot.left)
            calls.of(HubNative.DRIVE_BASE_DRIVE, sourceLine, ahead * speedAhead(speed), turn * turnRate(speed))
        }
    }

    fun stop(sourceLine: Int) {
        if (uses.areWheelsApart || uses.baseLine == null) {
            calls.on(HubNative.MOTOR_BRAKE, robot.left, sourceLine)
            calls.on(HubNative.MOTOR_BRAKE, robot.right, sourceLine)
        } else {
            calls.of(HubNative.DRIVE_BASE_BRAKE, sourceLine)
        }
    }

    fun straight(millimetres: Int, sourceLine: Int) = begin {
        calls.of(HubNative.DRIVE_BASE_STRAIGHT, sourceLine, millimetres)
    }

    fun turn(degrees: Int, sourceLine: Int) = begin { calls.of(HubNative.DRIVE_BASE_TURN, sourceLine, degrees) }

    /** Whether the last move goes on; not if a later command took its place. */
    val isMoving: Boolean get() = base?.let { it.commands == move && !it.isDone } == true

    fun setPower(side: PowerSide, power: Int, sourceLine: Int) {
        val speed = HubConstants.speedOf(power)
        if (side != PowerSide.RIGHT) speeds[robot.left] = speed
        if (side != PowerSide.LEFT) speeds[robot.right] = speed
        if (!uses.areWheelsApart) {
            // A hub refuses what its motors cannot do.
            val straight = minOf(speedAhead(speed), base?.straightLimit ?: Int.MAX_VALUE)
            val turn = minOf(turnRate(speed), base?.turnLimit ?: Int.MAX_VALUE)
            calls.of(HubNative.DRIVE_BASE_SETTINGS, sourceLine, straight, turn)
        }
    }

    fun setPower(motor: MotorPort, power: Int) {
        speeds[motor] = HubConstants.speedOf(power)
    }

    fun run(motor: MotorPort, sign: Int, sourceLine: Int) =
        calls.on(HubNative.MOTOR_RUN, motor, sourceLine, sign * speedOf(motor))

    private fun speedOf(motor: MotorPort): Int = speeds.getValue(motor)

    private inline fun begin(call: () -> Unit) {
        call()
        move = base?.commands ?: 0
    }

    /** Millimetres a second of wheels that turn [degrees] a second. */
    private fun speedAhead(degrees: Int): Int =
        roundAsPython(degrees * PI * robot.wheelDiameter / HubConstants.FULL_TURN)

    /** Degrees a second that the robot turns with them. */
    private fun turnRate(degrees: Int): Int = roundAsPython(degrees * robot.wheelDiameter / robot.track)
}

/** Makes the calls of a program to its hub; one that the hub refuses ends the program. */
internal class HubCalls(val hub: Hub, private val messages: HubErrorMessages) {
    fun of(native: HubNative, sourceLine: Int, vararg numbers: Int) = make(HubCall.of(native, *numbers), sourceLine)

    fun on(native: HubNative, motor: MotorPort, sourceLine: Int, vararg numbers: Int) =
        make(HubCall.on(native, HubPort.of(motor), *numbers), sourceLine)

    fun make(call: HubCall, sourceLine: Int) {
        val error = hub.call(call, sourceLine) ?: return
        fail(messages.reason(error, call))
    }
}

/** The nearest whole number; of two the even one, as Python's `round`. */
internal fun roundAsPython(value: Double): Int {
    val below = floor(value)
    val rest = value - below
    val isUp = rest > HALF || (rest == HALF && below.toLong() % 2 != 0L)
    return (if (isUp) below + 1 else below).toInt()
}

private const val HALF = 0.5
