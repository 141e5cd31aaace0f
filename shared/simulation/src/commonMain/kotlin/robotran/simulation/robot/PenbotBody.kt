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

/** The penbot as a body of the physics. */
internal class PenbotBody(private val physics: PhysicsWorld, private val trigonometry: Trigonometry, start: Pose) {
    /** Its index in the physics. */
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
        physics.setMass(body, Penbot.MASS_POSITION, 0.0, Penbot.MASS, Penbot.INERTIA)
    }

    /** Its motion after the last step. */
    var motion: BodyMotion = physics.motion(body)
        private set

    val leftBumperTouches: Boolean get() = touches(leftBumper)
    val rightBumperTouches: Boolean get() = touches(rightBumper)

    /** The kinds that any part of it touches after the last step: a bit for each [TouchKind], the first the lowest. */
    val touchedKinds: Int get() = contacts ushr PhysicsWorld.FIXTURE_BITS

    val pose: Pose
        get() = Pose(
            motion.x,
            motion.y,
            normalHeading(trigonometry.angle(motion.cosine, motion.sine) / RADIANS_PER_DEGREE),
        )

    /** Applies the impulses of the tyres before a physics step. */
    fun push(rollingImpulses: TyreImpulses) {
        push(rollingImpulses.left, rollingImpulses.leftSideways, Penbot.WHEEL_TRACK / 2)
        push(rollingImpulses.right, rollingImpulses.rightSideways, -Penbot.WHEEL_TRACK / 2)
    }

    /** Updates it after a physics step. */
    fun update() {
        motion = physics.motion(body)
        contacts = physics.contacts(body)
    }

    /** Puts it down elsewhere. */
    fun place(pose: Pose) {
        physics.place(body, pose.x, pose.y, pose.heading * RADIANS_PER_DEGREE)
        motion = physics.motion(body)
        contacts = 0
    }

    /** Forward speed over the floor at the point of the axle that is [place] left of its centre. */
    fun groundSpeed(place: Double): Double =
        motion.velocityX * motion.cosine + motion.velocityY * motion.sine - motion.angularVelocity * place

    /** The world point that is [forwards] of the midpoint between the wheels. */
    fun pointAhead(forwards: Double) = Point(motion.x + forwards * motion.cosine, motion.y + forwards * motion.sine)

    private fun touches(fixture: Int) = contacts shr fixture and 1 == 1

    /** Applies an impulse, in the robot's frame, at the point of the axle that is [place] left of its centre. */
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
