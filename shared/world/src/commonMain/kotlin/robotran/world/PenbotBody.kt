package robotran.world

import robotran.world.physics.BodyMotion
import robotran.world.physics.PhysicsEngine
import robotran.world.physics.PhysicsWorld
import kotlin.math.PI

/** The penbot as a body among the world's walls. */
internal class PenbotBody(private val physics: PhysicsWorld, private val engine: PhysicsEngine, start: Pose) {
    private val body = physics.addBody(start.x, start.y, start.heading / DEGREES_PER_RADIAN)
    private val leftBumper: Int
    private val rightBumper: Int

    init {
        addBox(Penbot.CHASSIS_BACK, Penbot.CHASSIS_FRONT, 0.0, Penbot.CHASSIS_WIDTH)
        val wheelPlace = Penbot.WHEEL_TRACK / 2
        val wheelRadius = Penbot.WHEEL_DIAMETER / 2
        addBox(-wheelRadius, wheelRadius, wheelPlace, Penbot.WHEEL_WIDTH)
        addBox(-wheelRadius, wheelRadius, -wheelPlace, Penbot.WHEEL_WIDTH)
        val bumperPlace = (Penbot.BUMPER_GAP + Penbot.BUMPER_WIDTH) / 2
        leftBumper = addBox(Penbot.CHASSIS_FRONT, Penbot.BUMPER_FRONT, bumperPlace, Penbot.BUMPER_WIDTH)
        rightBumper = addBox(Penbot.CHASSIS_FRONT, Penbot.BUMPER_FRONT, -bumperPlace, Penbot.BUMPER_WIDTH)
        physics.setMass(body, Penbot.MASS_PLACE, 0.0, Penbot.MASS, Penbot.INERTIA)
    }

    /** As it is after the last step. */
    var motion: BodyMotion = physics.motion(body)
        private set

    var leftBumperTouches = false
        private set

    var rightBumperTouches = false
        private set

    val pose: Pose
        get() = Pose(motion.x, motion.y, normalHeading(engine.trigonometry.angle(motion.cosine, motion.sine) * DEGREES_PER_RADIAN))

    /** Lets the physics make one step in which the tyres turn at these speeds, in cm/s. */
    fun step(leftSpeed: Double, rightSpeed: Double) {
        val traction = traction(motion, leftSpeed, rightSpeed)
        push(traction.left, traction.leftSideways, Penbot.WHEEL_TRACK / 2)
        push(traction.right, traction.rightSideways, -Penbot.WHEEL_TRACK / 2)
        physics.step()
        motion = physics.motion(body)
        val touched = physics.touchedFixtures(body)
        leftBumperTouches = touched shr leftBumper and 1 == 1
        rightBumperTouches = touched shr rightBumper and 1 == 1
    }

    /** An impulse, seen from the robot, at the place on the axle that lies [place] to the left of its middle. */
    private fun push(forwards: Double, sideways: Double, place: Double) = with(motion) {
        physics.applyImpulse(
            body,
            forwards * cosine - sideways * sine, forwards * sine + sideways * cosine,
            x - place * sine, y + place * cosine,
        )
    }

    private fun addBox(back: Double, front: Double, middle: Double, width: Double): Int {
        val left = middle + width / 2
        val right = middle - width / 2
        return physics.addPolygon(body, doubleArrayOf(back, right, front, right, front, left, back, left), Penbot.SHELL_FRICTION)
    }

    private companion object {
        const val DEGREES_PER_RADIAN = 180.0 / PI
    }
}

/** Puts a wall into the physics as a body that does not move. */
internal fun PhysicsWorld.addWall(wall: Wall) {
    val along = length(wall.to.x - wall.from.x, wall.to.y - wall.from.y)
    val directionX = if (along == 0.0) 1.0 else (wall.to.x - wall.from.x) / along
    val directionY = if (along == 0.0) 0.0 else (wall.to.y - wall.from.y) / along
    val reach = (along + wall.thickness) / 2
    val half = wall.thickness / 2

    fun corner(forwards: Double, leftwards: Double) =
        listOf(forwards * directionX - leftwards * directionY, forwards * directionY + leftwards * directionX)
    val corners = corner(-reach, -half) + corner(reach, -half) + corner(reach, half) + corner(-reach, half)
    val body = addBody((wall.from.x + wall.to.x) / 2, (wall.from.y + wall.to.y) / 2, 0.0)
    addPolygon(body, corners.toDoubleArray(), Penbot.SHELL_FRICTION)
}
