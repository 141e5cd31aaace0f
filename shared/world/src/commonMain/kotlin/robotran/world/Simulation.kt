package robotran.world

import robotran.rom.MotorState
import robotran.world.physics.PhysicsEngine

/** The world outside the brick, moved on by what the brick tells its motors. */
internal class Simulation(world: World, engine: PhysicsEngine) {
    private val physics = engine.createWorld(SimulationLimits.PHYSICS)
    private val body: PenbotBody
    private val leftMotor = Motor()
    private val rightMotor = Motor()
    private val pen = PenLift()
    private val leftBumper = Bumper()
    private val rightBumper = Bumper()
    private val inkWriter = InkWriter(world.paper)
    private var ticks = 0L
    private var leftTravel = 0.0
    private var rightTravel = 0.0
    private var leftTurned = 0.0
    private var rightTurned = 0.0

    init {
        world.walls.forEach(physics::addWall)
        body = PenbotBody(physics, engine, world.start)
    }

    /** How often the robot has run into something; both bumpers at once are one bump. */
    var bumps = 0
        private set

    val ink: Ink get() = inkWriter.ink

    val robot: RobotState
        get() = RobotState(
            pose = body.pose,
            leftWheelTurn = leftTurned / Penbot.WHEEL_CIRCUMFERENCE,
            rightWheelTurn = rightTurned / Penbot.WHEEL_CIRCUMFERENCE,
            penDown = pen.isDown,
            leftBumperPressed = leftBumper.isPressed,
            rightBumperPressed = rightBumper.isPressed,
        )

    /** Lets one millisecond pass in which the motors are told this. */
    fun tick(left: MotorState, lift: MotorState, right: MotorState) {
        ticks++
        roll(leftMotor.tick(left), rightMotor.tick(right))
        pen.tick(lift)
        if (ticks % SimulationLimits.TICKS_PER_PHYSICS_STEP == 0L) step()
        touch()
    }

    /** Adds what a run is told apart by. */
    fun addTo(hash: TraceHash) {
        val motion = body.motion
        hash.add(motion.x.toRawBits())
        hash.add(motion.y.toRawBits())
        hash.add(motion.cosine.toRawBits())
        hash.add(motion.sine.toRawBits())
    }

    fun close() = physics.close()

    private fun roll(left: Double, right: Double) {
        leftTravel += left
        rightTravel += right
        leftTurned += left
        rightTurned += right
    }

    private fun step() {
        body.step(leftTravel / SimulationLimits.PHYSICS_STEP_SECONDS, rightTravel / SimulationLimits.PHYSICS_STEP_SECONDS)
        leftTravel = 0.0
        rightTravel = 0.0
        inkWriter.move(body.motion.x, body.motion.y, pen.isDown)
    }

    private fun touch() {
        val wasFree = !leftBumper.isPressed && !rightBumper.isPressed
        leftBumper.tick(body.leftBumperTouches)
        rightBumper.tick(body.rightBumperTouches)
        if (wasFree && (leftBumper.isPressed || rightBumper.isPressed)) bumps++
    }
}
