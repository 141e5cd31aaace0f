package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.noise.BatteryNoise
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.noise.WheelNoise
import robotran.simulation.noise.realStart
import robotran.simulation.physics.PhysicsWorld
import robotran.simulation.state.RobotState
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.NxtMotorParameters
import robotran.world.RobotDescription
import robotran.world.TouchKind
import robotran.world.geometry.Pose
import robotran.world.geometry.Trigonometry
import robotran.world.isSameThing
import robotran.world.robot.RobotParameters
import robotran.world.robot.bumpers

/** A robot without its brick: wheels, pen and bumpers on a physics body. */
internal class SimulatedRobot(
    physics: PhysicsWorld,
    trigonometry: Trigonometry,
    plannedStart: Pose,
    private val robot: RobotDescription,
    streams: NoiseStreams,
    private val realism: Double,
) {
    /** Its real start pose. */
    val start = realStart(plannedStart, streams, realism)
    val parameters = RobotParameters.of(robot)
    val body = RobotBody(physics, trigonometry, start, robot, parameters)
    val leftNoise = WheelNoise(streams, "left wheel", realism)
    val rightNoise = WheelNoise(streams, "right wheel", realism)

    /** null for a brick whose motors do not count. */
    private val nxt = if (robot.brick.hasMotorCounters) NxtMotors(robot, parameters, streams, realism) else null
    private val trim = robot.buggy?.trim
    val leftWheel = Wheel(leftNoise, nxt?.left ?: timedMotor(trim?.left), parameters, nxt?.play("left wheel"))
    val rightWheel = Wheel(rightNoise, nxt?.right ?: timedMotor(trim?.right), parameters, nxt?.play("right wheel"))
    val battery = if (nxt == null) {
        BatteryNoise(streams, realism)
    } else {
        BatteryNoise(streams, realism, NxtMotorParameters.VOLTS, NxtRealism.EMPTY_BATTERY)
    }
    private val bumperParts = robot.bumpers

    /** In the order of the robot's bumpers. */
    val bumpers = bumperParts.indices.map { Bumper(streams.named(bumperName(it)), realism) }
    private val pen = robot.pen?.takeIf { nxt == null }?.let { PenLift() }
    private val left = MotorCommand(robot.drive.reversed)
    private val right = MotorCommand(robot.drive.reversed)
    private val traction = Traction(parameters)
    private var rollingImpulses = traction.rollingImpulses(body.motion, 0.0, 0.0)
    private var touchedKinds = 0

    /** Number of collisions; several bumpers at once count as one. */
    var bumps = 0
        private set

    /** The millisecond of the latest of [bumps]; null before the first. */
    var bumpedAt: Long? = null
        private set

    val penIsDown: Boolean get() = if (nxt == null) pen?.isDown == true else nxt.penIsDown

    /** Degrees that the turret has turned to the left. */
    val turret: Double get() = nxt?.turret ?: 0.0

    val state: RobotState
        get() = RobotState(
            pose = body.pose,
            leftWheelTurn = leftWheel.turned / parameters.wheelCircumference,
            rightWheelTurn = rightWheel.turned / parameters.wheelCircumference,
            penDown = penIsDown,
            leftBumperPressed = isPressed(BumperSide.LEFT),
            rightBumperPressed = isPressed(BumperSide.RIGHT),
            touching = kindsOf(body.touchedKinds),
            touched = kindsOf(touchedKinds),
            penDepth = if (nxt == null) pen?.depth ?: 0.0 else nxt.penDepth,
            pressed = pressed,
            motorDegrees = if (nxt == null) emptyList() else robot.brick.motorPorts.map(::motorDegrees),
            turret = turret,
        )

    /** The switch of a bumper of this robot, plugged in or not. */
    fun bumper(part: BumperPart): Bumper = bumpers[bumperParts.indexOfFirst { it.isSameThing(part) }]

    /** Degrees that the hub of a motor that counts has turned since the session began, forwards for the motor positive. */
    fun motorDegrees(port: MotorPort): Double = when {
        nxt == null -> 0.0
        port == robot.drive.left -> nxt.degreesOf(leftWheel.motorTravel)
        port == robot.drive.right -> nxt.degreesOf(rightWheel.motorTravel)
        port == nxt.thirdPort -> nxt.third.degrees
        else -> 0.0
    }

    /**
     * Advances by the millisecond number [tick] with the commands of the motors, which [command] tells.
     *
     * @param isRegulated whether something makes up for a strong or weak motor of the wheels.
     */
    fun tick(tick: Long, isRegulated: Boolean = false, command: (MotorPort) -> MotorState) {
        if (leftNoise.isOn) battery.tick(nxt?.currents ?: robot.brick.motorPorts.sumOf { driven(command(it)) })
        leftWheel.tick(left.of(command(robot.drive.left)), battery.share, tick, isRegulated)
        rightWheel.tick(right.of(command(robot.drive.right)), battery.share, tick, isRegulated)
        pen?.tick(command(checkNotNull(robot.pen).motor))
        nxt?.thirdPort?.let { nxt.third.tick(command(it), battery.share, tick) }
        touch(tick)
    }

    /** Call before a physics step. */
    fun beginStep() {
        leftWheel.beginStep()
        rightWheel.beginStep()
        rollingImpulses = traction.rollingImpulses(body.motion, leftWheel.speed, rightWheel.speed)
        body.push(rollingImpulses)
    }

    /** Call after a physics step. */
    fun endStep() {
        body.update()
        touchedKinds = touchedKinds or body.touchedKinds
        val left = leftWheel.speedChange
        val right = rightWheel.speedChange
        val place = parameters.wheelTrack / 2
        leftWheel.endStep(
            force(rollingImpulses.left - traction.rollingImpulse(left, right)),
            rollingImpulses.leftSlips,
            body.groundSpeed(place),
        )
        rightWheel.endStep(
            force(rollingImpulses.right - traction.rollingImpulse(right, left)),
            rollingImpulses.rightSlips,
            body.groundSpeed(-place),
        )
    }

    /** A motor that does not count; [trim] of one of a buggy is what its programs slow down its wheel by. */
    private fun timedMotor(trim: Double?): MotorModel =
        if (trim == null) RcxMotor(parameters) else BuggyMotor(parameters, realism, trim)

    private fun force(impulse: Double) = impulse / SimulationLimits.PHYSICS_STEP_SECONDS

    private fun driven(command: MotorState): Double = if (command.mode == MotorMode.FORWARD ||
        command.mode == MotorMode.BACKWARD
    ) {
        if (robot.buggy == null) (command.power + 1) / SLOTS else command.power / PERCENT
    } else {
        0.0
    }

    private fun touch(tick: Long) {
        var wasFree = true
        var isFree = true
        for (number in bumpers.indices) {
            val bumper = bumpers[number]
            if (bumper.isPressed) wasFree = false
            bumper.tick(body.bumperTouches(number))
            if (bumper.isPressed) isFree = false
        }
        if (wasFree && !isFree) {
            bumps++
            bumpedAt = tick
        }
    }

    private fun isPressed(side: BumperSide) =
        bumpers.indices.any { bumperParts[it].side == side && bumpers[it].isPressed }

    private val pressed: Set<Int>
        get() = if (bumpers.none { it.isPressed }) {
            emptySet()
        } else {
            bumpers.indices.filterTo(mutableSetOf()) { bumpers[it].isPressed }
        }

    /** The name of its stream of random numbers. */
    private fun bumperName(number: Int): String {
        val side = bumperParts[number].side
        val isFirst = side != null && bumperParts.indexOfFirst { it.side == side } == number
        return if (isFirst) "${side.name.lowercase()} bumper" else "bumper ${number + 1}"
    }

    private fun kindsOf(bits: Int): Set<TouchKind> =
        if (bits == 0) emptySet() else TouchKind.entries.filterTo(mutableSetOf()) { bits shr it.ordinal and 1 == 1 }

    private companion object {
        const val SLOTS = 8.0
        const val PERCENT = 100.0
    }
}

/** Turns the commands of a motor that is mounted the other way round. */
private class MotorCommand(private val isReversed: Boolean) {
    private var known: MotorState? = null
    private var turned: MotorState? = null

    fun of(command: MotorState): MotorState {
        if (!isReversed) return command
        if (command != known) {
            known = command
            turned = command.copy(
                mode = when (command.mode) {
                    MotorMode.FORWARD -> MotorMode.BACKWARD
                    MotorMode.BACKWARD -> MotorMode.FORWARD
                    else -> command.mode
                },
            )
        }
        return checkNotNull(turned)
    }
}
