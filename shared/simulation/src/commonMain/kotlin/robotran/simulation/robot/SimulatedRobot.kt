package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.noise.BatteryNoise
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.WheelNoise
import robotran.simulation.noise.realStart
import robotran.simulation.physics.PhysicsWorld
import robotran.simulation.state.RobotState
import robotran.world.Penbot
import robotran.world.TouchKind
import robotran.world.geometry.Pose
import robotran.world.geometry.Trigonometry

/** A penbot without its brick: wheels, pen and bumpers on a physics body. */
internal class SimulatedRobot(
    physics: PhysicsWorld,
    trigonometry: Trigonometry,
    plannedStart: Pose,
    streams: NoiseStreams,
    realism: Double,
) {
    /** Its real start pose. */
    val start = realStart(plannedStart, streams, realism)
    val body = PenbotBody(physics, trigonometry, start)
    val leftNoise = WheelNoise(streams, "left wheel", realism)
    val rightNoise = WheelNoise(streams, "right wheel", realism)
    val leftWheel = Wheel(leftNoise)
    val rightWheel = Wheel(rightNoise)
    val battery = BatteryNoise(streams, realism)
    val leftBumper = Bumper(streams.named("left bumper"), realism)
    val rightBumper = Bumper(streams.named("right bumper"), realism)
    private val pen = PenLift()
    private var rollingImpulses = rollingImpulses(body.motion, 0.0, 0.0)
    private var touchedKinds = 0

    /** Number of collisions; both bumpers at once count as one. */
    var bumps = 0
        private set

    /** The millisecond of the latest of [bumps]; null before the first. */
    var bumpedAt: Long? = null
        private set

    val penIsDown: Boolean get() = pen.isDown

    val state: RobotState
        get() = RobotState(
            pose = body.pose,
            leftWheelTurn = leftWheel.turned / Penbot.WHEEL_CIRCUMFERENCE,
            rightWheelTurn = rightWheel.turned / Penbot.WHEEL_CIRCUMFERENCE,
            penDown = pen.isDown,
            leftBumperPressed = leftBumper.isPressed,
            rightBumperPressed = rightBumper.isPressed,
            touching = kindsOf(body.touchedKinds),
            touched = kindsOf(touchedKinds),
            penDepth = pen.depth,
        )

    /** Advances by the millisecond number [tick] with these motor commands. */
    fun tick(left: MotorState, lift: MotorState, right: MotorState, tick: Long) {
        if (leftNoise.isOn) battery.tick(driven(left) + driven(lift) + driven(right))
        leftWheel.tick(left, battery.share, tick)
        rightWheel.tick(right, battery.share, tick)
        pen.tick(lift)
        touch(tick)
    }

    /** Call before a physics step. */
    fun beginStep() {
        leftWheel.beginStep()
        rightWheel.beginStep()
        rollingImpulses = rollingImpulses(body.motion, leftWheel.speed, rightWheel.speed)
        body.push(rollingImpulses)
    }

    /** Call after a physics step. */
    fun endStep() {
        body.update()
        touchedKinds = touchedKinds or body.touchedKinds
        val left = leftWheel.speedChange
        val right = rightWheel.speedChange
        val place = Penbot.WHEEL_TRACK / 2
        leftWheel.endStep(
            force(rollingImpulses.left - rollingImpulse(left, right)),
            rollingImpulses.leftSlips,
            body.groundSpeed(place),
        )
        rightWheel.endStep(
            force(rollingImpulses.right - rollingImpulse(right, left)),
            rollingImpulses.rightSlips,
            body.groundSpeed(-place),
        )
    }

    private fun force(impulse: Double) = impulse / SimulationLimits.PHYSICS_STEP_SECONDS

    private fun driven(told: MotorState): Double =
        if (told.mode == MotorMode.FORWARD || told.mode == MotorMode.BACKWARD) (told.power + 1) / SLOTS else 0.0

    private fun touch(tick: Long) {
        val wasFree = !leftBumper.isPressed && !rightBumper.isPressed
        leftBumper.tick(body.leftBumperTouches)
        rightBumper.tick(body.rightBumperTouches)
        if (wasFree && (leftBumper.isPressed || rightBumper.isPressed)) {
            bumps++
            bumpedAt = tick
        }
    }

    private fun kindsOf(bits: Int): Set<TouchKind> =
        if (bits == 0) emptySet() else TouchKind.entries.filterTo(mutableSetOf()) { bits shr it.ordinal and 1 == 1 }

    private companion object {
        const val SLOTS = 8.0
    }
}
