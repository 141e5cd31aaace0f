package robotran.simulation.robot

import robotran.simulation.physics.BodyMotion
import robotran.simulation.physics.PhysicsWorld
import robotran.world.Penbot
import robotran.world.TouchKind
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.normalHeading
import kotlin.math.PI

/** The penbot as a body in the physics. */
internal class PenbotBody(private val physics: PhysicsWorld, private val trigonometry: Trigonometry, start: Pose) {
    /** Its number in the physics. */
    val body = physics.addBody(TouchKind.ROBOTS.ordinal, start.x, start.y, start.heading * RADIANS_PER_DEGREE)
    private val leftBumper: Int
    private val rightBumper: Int
    private var contacts = 0

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

    val leftBumperTouches: Boolean get() = touches(leftBumper)
    val rightBumperTouches: Boolean get() = touches(rightBumper)

    /** What any part of it touches after the last step: a bit for each [TouchKind], the first the lowest. */
    val touchedKinds: Int get() = contacts ushr PhysicsWorld.FIXTURE_BITS

    val pose: Pose
        get() = Pose(
            motion.x,
            motion.y,
            normalHeading(trigonometry.angle(motion.cosine, motion.sine) / RADIANS_PER_DEGREE),
        )

    /** Before a step of the physics: the tyres push. */
    fun push(traction: TyreImpulses) {
        push(traction.left, traction.leftSideways, Penbot.WHEEL_TRACK / 2)
        push(traction.right, traction.rightSideways, -Penbot.WHEEL_TRACK / 2)
    }

    /** After a step of the physics. */
    fun update() {
        motion = physics.motion(body)
        contacts = physics.contacts(body)
    }

    /** Somebody has picked it up and put it down elsewhere. */
    fun place(pose: Pose) {
        physics.place(body, pose.x, pose.y, pose.heading * RADIANS_PER_DEGREE)
        motion = physics.motion(body)
        contacts = 0
    }

    /**
     * How fast it moves forwards over the floor at the place on the axle that lies [place] to the left of its middle.
     */
    fun groundSpeed(place: Double): Double =
        motion.velocityX * motion.cosine + motion.velocityY * motion.sine - motion.angularVelocity * place

    /** The place in the world of the point that lies [forwards] of the middle between its wheels. */
    fun pointAhead(forwards: Double) = Point(motion.x + forwards * motion.cosine, motion.y + forwards * motion.sine)

    private fun touches(fixture: Int) = contacts shr fixture and 1 == 1

    /** An impulse, seen from the robot, at the place on the axle that lies [place] to the left of its middle. */
    private fun push(forwards: Double, sideways: Double, place: Double) = with(motion) {
        if (forwards != 0.0 || sideways != 0.0) {
            physics.applyImpulse(
                body,
                forwards * cosine - sideways * sine,
                forwards * sine + sideways * cosine,
                x - place * sine,
                y + place * cosine,
            )
        }
    }

    private fun addBox(back: Double, front: Double, middle: Double, width: Double): Int {
        val left = middle + width / 2
        val right = middle - width / 2
        return physics.addPolygon(
            body,
            doubleArrayOf(back, right, front, right, front, left, back, left),
            Penbot.SHELL_FRICTION,
        )
    }
}
