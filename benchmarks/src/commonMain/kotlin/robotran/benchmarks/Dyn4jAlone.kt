package robotran.benchmarks

import robotran.world.physics.PhysicsEngine
import robotran.world.physics.PhysicsSettings
import robotran.world.physics.PhysicsWorld
import kotlin.time.DurationUnit

/** dyn4j with nothing around it, set as a session sets it: a box of the robot's size is pushed about between four walls for [VIRTUAL_TIME]. */
internal fun pushABoxAbout(physics: PhysicsEngine) {
    val world = physics.createWorld(SETTINGS)
    for (x in listOf(-5.0, 105.0)) world.box(world.addBody(x, 40.0, 0.0), width = 10.0, height = 90.0)
    for (y in listOf(-5.0, 85.0)) world.box(world.addBody(50.0, y, 0.0), width = 110.0, height = 10.0)
    val robot = world.addBody(50.0, 40.0, 0.3)
    world.box(robot, width = 14.0, height = 14.0)
    world.setMass(robot, 0.0, 0.0, mass = 0.6, inertia = 20.0)
    repeat((VIRTUAL_TIME.toDouble(DurationUnit.SECONDS) / SETTINGS.stepSeconds).toInt()) { step ->
        val motion = world.motion(robot)
        val side = if (step / STEPS_OF_A_DRIVE % 2 == 0) 1.0 else -1.0
        world.applyImpulse(robot, side * motion.cosine, side * motion.sine, motion.x, motion.y)
        world.step()
    }
    world.close()
}

private fun PhysicsWorld.box(
    body: Int,
    width: Double,
    height: Double,
) {
    val x = width / 2
    val y = height / 2
    addPolygon(body, doubleArrayOf(-x, -y, x, -y, x, y, -x, y), friction = 0.3)
}

private const val STEPS_OF_A_DRIVE = 400

/** The session's own. */
private val SETTINGS =
    PhysicsSettings(
        stepSeconds = 0.005,
        stepParts = 2,
        lengthTolerance = 0.02,
        velocityIterations = 10,
        positionIterations = 5,
    )
