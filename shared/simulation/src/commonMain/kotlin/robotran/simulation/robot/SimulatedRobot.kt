package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
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
import robotran.world.NxtMotorFigures
import robotran.world.Penbot
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.TouchKind
import robotran.world.geometry.Pose
import robotran.world.geometry.Trigonometry
import robotran.world.isSameThing
import robotran.world.robot.RobotFigures
import robotran.world.robot.bumpers

/** A robot without its brick: wheels, pen and bumpers on a physics body. */
internal class SimulatedRobot(
    physics: PhysicsWorld,
    trigonometry: Trigonometry,
    plannedStart: Pose,
    private val robot: RobotDescription,
    streams: NoiseStreams,
    realism: Double,
) {
    private val isNxt = robot.brick == BrickKind.NXT

    /** Its real start pose. */
    val start = realStart(plannedStart, streams, realism)
    val figures = RobotFigures.of(robot)
    val body = RobotBody(physics, trigonometry, start, robot, figures)
    val leftNoise = WheelNoise(streams, "left wheel", realism)
    val rightNoise = WheelNoise(streams, "right wheel", realism)
    private val leftMotor = motor()
    private val rightMotor = motor()
    val leftWheel = Wheel(leftNoise, leftMotor, figures, play("left wheel", streams, realism))
    val rightWheel = Wheel(rightNoise, rightMotor, figures, play("right wheel", streams, realism))
    val battery = if (isNxt) {
        BatteryNoise(streams, realism, NxtMotorFigures.VOLTS, NxtRealism.EMPTY_BATTERY)
    } else {
        BatteryNoise(streams, realism)
    }
    private val bumperParts = robot.bumpers

    /** In the order of the robot's bumpers. */
    val bumpers = bumperParts.indices.map { Bumper(streams.named(bumperName(it)), realism) }
    private val pen = robot.pen?.takeIf { !isNxt }?.let { PenLift() }

    /** The motor of an NXT that drives no wheel: that of the pen or a turret, or a free one. */
    private val small = if (isNxt) smallMotor(streams, realism) else null
    private val smallPort = MotorPort.entries.first { it != robot.drive.left && it != robot.drive.right }
    private val degreesOfCentimetre = robot.drive.gear * FULL_TURN / figures.wheelCircumference *
        (if (robot.drive.reversed) -1 else 1)
    private val left = MotorCommand(robot.drive.reversed)
    private val right = MotorCommand(robot.drive.reversed)
    private val traction = Traction(figures)
    private var rollingImpulses = traction.rollingImpulses(body.motion, 0.0, 0.0)
    private var touchedKinds = 0

    /** Number of collisions; several bumpers at once count as one. */
    var bumps = 0
        private set

    /** The millisecond of the latest of [bumps]; null before the first. */
    var bumpedAt: Long? = null
        private set

    /** 0 at the pen's upper end stop, 1 at the lower. */
    private val penDepth: Double
        get() = when {
            small == null -> pen?.depth ?: 0.0
            robot.pen == null -> 0.0
            else -> (small.degrees - NxtMotorFigures.PEN_TOP) / (NxtMotorFigures.PEN_BOTTOM - NxtMotorFigures.PEN_TOP)
        }

    val penIsDown: Boolean get() = if (small == null) pen?.isDown == true else penDepth >= Penbot.PEN_CONTACT

    /** Degrees that the turret has turned to the left. */
    val turret: Double get() = if (robot.hasTurret && small != null) small.degrees else 0.0

    val state: RobotState
        get() = RobotState(
            pose = body.pose,
            leftWheelTurn = leftWheel.turned / figures.wheelCircumference,
            rightWheelTurn = rightWheel.turned / figures.wheelCircumference,
            penDown = penIsDown,
            leftBumperPressed = isPressed(BumperSide.LEFT),
            rightBumperPressed = isPressed(BumperSide.RIGHT),
            touching = kindsOf(body.touchedKinds),
            touched = kindsOf(touchedKinds),
            penDepth = penDepth,
            pressed = pressed,
            motorDegrees = if (isNxt) MotorPort.entries.map(::motorDegrees) else emptyList(),
            turret = turret,
        )

    /** The switch of a bumper of this robot, plugged in or not. */
    fun bumper(part: BumperPart): Bumper = bumpers[bumperParts.indexOfFirst { it.isSameThing(part) }]

    /** Degrees that the hub of a motor of an NXT has turned since the session began, forwards for the motor positive. */
    fun motorDegrees(port: MotorPort): Double = when (port) {
        robot.drive.left -> leftWheel.motorTravel * degreesOfCentimetre
        robot.drive.right -> rightWheel.motorTravel * degreesOfCentimetre
        else -> small?.degrees ?: 0.0
    }

    /**
     * Advances by the millisecond number [tick] with the commands of the motors A, B and C.
     *
     * @param isRegulated whether something makes up for a strong or weak motor of the wheels.
     */
    fun tick(a: MotorState, b: MotorState, c: MotorState, tick: Long, isRegulated: Boolean = false) {
        if (leftNoise.isOn) battery.tick(if (isNxt) currents else driven(a) + driven(b) + driven(c))
        leftWheel.tick(left.of(command(robot.drive.left, a, b, c)), battery.share, tick, isRegulated)
        rightWheel.tick(right.of(command(robot.drive.right, a, b, c)), battery.share, tick, isRegulated)
        pen?.tick(command(checkNotNull(robot.pen).motor, a, b, c))
        small?.tick(command(smallPort, a, b, c), battery.share, tick)
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
        val place = figures.wheelTrack / 2
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

    private fun motor(): MotorModel = if (isNxt) NxtMotor(figures) else RcxMotor(figures)

    private fun play(side: String, streams: NoiseStreams, realism: Double): MotorPlay? {
        if (!isNxt || realism == 0.0) return null
        val degrees = NxtRealism.LEAST_PLAY + (NxtRealism.MOST_PLAY - NxtRealism.LEAST_PLAY) *
            streams.named("$side: play").share()
        return MotorPlay(realism * degrees / FULL_TURN / robot.drive.gear * figures.wheelCircumference)
    }

    private fun smallMotor(streams: NoiseStreams, realism: Double): SmallMotor {
        val port = MotorPort.entries.first { it != robot.drive.left && it != robot.drive.right }
        val noise = WheelNoise(streams, "motor $port", realism)
        return when {
            robot.pen != null -> SmallMotor(noise, NxtMotorFigures.PEN_TOP, NxtMotorFigures.PEN_BOTTOM)
            robot.hasTurret -> SmallMotor(noise, -NxtMotorFigures.TURRET_END, NxtMotorFigures.TURRET_END)
            else -> SmallMotor(noise, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
        }
    }

    /** What the motors of an NXT draw together, as much as the battery's fuse lets through. */
    private val currents: Double
        get() = minOf(
            NxtRealism.MAX_CURRENT,
            (leftMotor as NxtMotor).current + (rightMotor as NxtMotor).current + (small?.current ?: 0.0),
        )

    private val RobotDescription.hasTurret: Boolean get() = parts.any { it is SensorPart && it.turret != null }

    private fun force(impulse: Double) = impulse / SimulationLimits.PHYSICS_STEP_SECONDS

    private fun driven(told: MotorState): Double =
        if (told.mode == MotorMode.FORWARD || told.mode == MotorMode.BACKWARD) (told.power + 1) / SLOTS else 0.0

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

    private fun command(port: MotorPort, a: MotorState, b: MotorState, c: MotorState) = when (port) {
        MotorPort.A -> a
        MotorPort.B -> b
        MotorPort.C -> c
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
        const val FULL_TURN = 360.0
    }
}

/** Turns the commands of a motor that is mounted the other way round. */
private class MotorCommand(private val isReversed: Boolean) {
    private var known: MotorState? = null
    private var turned: MotorState? = null

    fun of(told: MotorState): MotorState {
        if (!isReversed) return told
        if (told != known) {
            known = told
            turned = told.copy(
                mode = when (told.mode) {
                    MotorMode.FORWARD -> MotorMode.BACKWARD
                    MotorMode.BACKWARD -> MotorMode.FORWARD
                    else -> told.mode
                },
            )
        }
        return checkNotNull(turned)
    }
}
