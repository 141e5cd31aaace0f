package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.hub.messages.HubErrorMessages
import robotran.hub.messages.reason
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubCall
import robotran.hub.program.HubNative
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.speedAhead
import robotran.robolang.robot.turnRate
import robotran.robolang.syntax.PowerSide

/** The wheels of a robot with a hub: together as a driving base or, if their powers differ, each by its motor. */
internal class HubDrive(private val robot: RobotTarget.Hub, private val uses: HubUses, private val calls: HubCalls) {
    private val speeds = MotorPort.entries.associateWith {
        HubFigures.speedOf(HubFigures.FIRST_POWER)
    }.toMutableMap()
    private val base get() = calls.hub.driveBase
    private var move = 0

    /** The direction of the base since its command of that number, and of each motor. */
    private var direction = Direction(0, 0, NEVER)
    private val directions = mutableMapOf<MotorPort, Direction>()

    /** Drives ahead or back by [ahead] 1 or -1, or turns to the right or left by [turn]. */
    fun start(ahead: Int, turn: Int, sourceLine: Int) {
        if (uses.areWheelsApart) {
            run(robot.left, ahead + turn, sourceLine)
            run(robot.right, ahead - turn, sourceLine)
        } else {
            val speed = speedOf(robot.left)
            val straight = ahead * robot.speedAhead(speed)
            calls.of(HubNative.DRIVE_BASE_DRIVE, sourceLine, straight, turn * robot.turnRate(speed))
            direction = Direction(ahead, turn, base?.commands ?: NEVER)
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
        val speed = HubFigures.speedOf(power)
        if (side != PowerSide.RIGHT) speeds[robot.left] = speed
        if (side != PowerSide.LEFT) speeds[robot.right] = speed
        if (uses.areWheelsApart) {
            if (side != PowerSide.RIGHT) runOn(robot.left, sourceLine)
            if (side != PowerSide.LEFT) runOn(robot.right, sourceLine)
        } else {
            calls.of(HubNative.DRIVE_BASE_SETTINGS, sourceLine, robot.speedAhead(speed), robot.turnRate(speed))
            if (base?.commands == direction.command) start(direction.ahead, direction.turn, sourceLine)
        }
    }

    fun setPower(motor: MotorPort, power: Int, sourceLine: Int) {
        speeds[motor] = HubFigures.speedOf(power)
        runOn(motor, sourceLine)
    }

    /** A motor that turns goes on with its new speed: a hub takes no other for what it does already. */
    private fun runOn(motor: MotorPort, sourceLine: Int) {
        val direction = directions[motor] ?: return
        if (commandsOf(motor) == direction.command) run(motor, direction.ahead, sourceLine)
    }

    fun run(motor: MotorPort, sign: Int, sourceLine: Int) {
        calls.on(HubNative.MOTOR_RUN, motor, sourceLine, sign * speedOf(motor))
        directions[motor] = Direction(sign, 0, commandsOf(motor))
    }

    private fun commandsOf(motor: MotorPort): Int = calls.hub.motor(HubPort.of(motor))?.commands ?: NEVER

    private fun speedOf(motor: MotorPort): Int = speeds.getValue(motor)

    private inline fun begin(call: () -> Unit) {
        call()
        move = base?.commands ?: 0
    }

    /** [ahead] or to the right, 1 or -1, since the command of this number. */
    private class Direction(val ahead: Int, val turn: Int, val command: Int)

    private companion object {
        const val NEVER = -1
    }
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
