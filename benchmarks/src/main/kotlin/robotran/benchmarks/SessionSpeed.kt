package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import robotran.physics.RigidWorld
import robotran.robolang.Calibration
import robotran.robolang.RobolangResult
import robotran.robolang.readRobolang
import robotran.rom.BrickButton
import robotran.world.BuiltInWorlds
import robotran.world.Penbot
import robotran.world.Session
import robotran.world.SessionInput
import robotran.world.physics.loadPhysicsEngine
import kotlin.time.Duration.Companion.seconds

/** How many times real time a session runs that drives, draws and runs into walls all the time, and what of it is the physics alone. */
internal fun sessionSpeed(): String {
    val session = median(RUNS, ::driveForAMinute)
    val physics = median(RUNS, ::stepForAMinute)
    return "a minute of driving among walls runs %.0f times as fast as real time, ".format(VIRTUAL_TIME / session) +
        "%.1f times as long as dyn4j alone with one box between four walls".format(session / physics)
}

private fun driveForAMinute() {
    val calibration = Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
    val program = (readRobolang("benchmark", PROGRAM, calibration) as RobolangResult.Ready).program
    val session = Session(BuiltInWorlds.plain, listOf(program), runBlocking { loadPhysicsEngine() })
    session.apply(SessionInput.Press(BrickButton.RUN))
    session.apply(SessionInput.Release(BrickButton.RUN))
    session.advance(VIRTUAL_TIME.inWholeMilliseconds.toInt())
    session.close()
}

/** dyn4j alone: a box of the robot's size pushed about between four walls. */
private fun stepForAMinute() {
    val world = RigidWorld(STEP_SECONDS, STEP_PARTS, LENGTH_TOLERANCE, VELOCITY_ITERATIONS, POSITION_ITERATIONS)
    for ((x, y) in listOf(-5.0 to 40.0, 105.0 to 40.0, 50.0 to -5.0, 50.0 to 85.0)) wall(world, x, y)
    val robot = world.addBody(50.0, 40.0, 0.3)
    box(world, robot, 14.0, 14.0)
    world.setMass(robot, 0.0, 0.0, 0.6, 20.0)
    repeat(STEPS) { step ->
        val side = if (step / 400 % 2 == 0) 1.0 else -1.0
        world.applyImpulse(robot, side * world.cosine(robot), side * world.sine(robot), world.x(robot), world.y(robot))
        world.step()
    }
}

private fun wall(world: RigidWorld, x: Double, y: Double) {
    val upright = y == 40.0
    box(world, world.addBody(x, y, 0.0), if (upright) 10.0 else 110.0, if (upright) 90.0 else 10.0)
}

private fun box(world: RigidWorld, body: Int, width: Double, height: Double) {
    val x = width / 2
    val y = height / 2
    world.addPolygon(body, doubleArrayOf(-x, -y, x, -y, x, y, -x, y), 0.3)
}

private const val PROGRAM = "pen down\nrepeat 40 times\nforward 30\nturn right 97\nbackward 20\nend\n"
private const val RUNS = 5

// The session's own settings of the physics.
private const val STEP_SECONDS = 0.005
private const val STEP_PARTS = 2
private const val LENGTH_TOLERANCE = 0.02
private const val VELOCITY_ITERATIONS = 10
private const val POSITION_ITERATIONS = 5
private const val STEPS = 12_000
private val VIRTUAL_TIME = 60.seconds
