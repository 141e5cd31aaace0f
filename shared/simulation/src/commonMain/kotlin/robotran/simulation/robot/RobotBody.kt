package robotran.simulation.robot

import robotran.simulation.physics.BodyMotion
import robotran.simulation.physics.PhysicsWorld
import robotran.world.Penbot
import robotran.world.RobotDescription
import robotran.world.TouchKind
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.normalHeading
import robotran.world.robot.RobotParameters
import robotran.world.robot.bumpers
import robotran.world.robot.chassisCorners
import robotran.world.robot.corners

/** A robot as a body of the physics. */
internal class RobotBody(
    private val physics: PhysicsWorld,
    private val trigonometry: Trigonometry,
    start: Pose,
    robot: RobotDescription,
    private val parameters: RobotParameters,
) {
    /** Its index in the physics. */
    val body = physics.addBody(TouchKind.ROBOTS.ordinal, start.x, start.y, start.heading * RADIANS_PER_DEGREE)
    private val bumpers: IntArray
    private var contacts = 0

    init {
        // The order of the shapes is part of the result of a run.
        addPolygon(robot.chassisCorners)
        val wheelPlace = parameters.wheelTrack / 2
        val wheelRadius = parameters.wheelDiameter / 2
        addBox(-wheelRadius, wheelRadius, wheelPlace, parameters.wheelWidth)
        addBox(-wheelRadius, wheelRadius, -wheelPlace, parameters.wheelWidth)
        bumpers = IntArray(robot.bumpers.size) { addPolygon(robot.bumpers[it].corners) }
        physics.setMass(body, parameters.massX, parameters.massY, parameters.mass, parameters.inertia)
    }

    /** Its motion after the last step. */
    var motion: BodyMotion = physics.motion(body)
        private set

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
        push(rollingImpulses.left, rollingImpulses.leftSideways, parameters.wheelTrack / 2)
        push(rollingImpulses.right, rollingImpulses.rightSideways, -parameters.wheelTrack / 2)
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

    /** The world point that is [forwards] of the midpoint between the wheels and [leftwards] of the middle line. */
    fun point(forwards: Double, leftwards: Double): Point = with(motion) {
        // A product with 0 must not touch what is on the middle line.
        if (leftwards == 0.0) return pointAhead(forwards)
        Point(
            x + forwards * cosine - leftwards * sine,
            y + forwards * sine + leftwards * cosine,
        )
    }

    /** Whether the bumper with this index among the robot's bumpers touches anything. */
    fun bumperTouches(number: Int): Boolean = contacts shr bumpers[number] and 1 == 1

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

    private fun addPolygon(corners: List<Point>): Int {
        val coordinates = DoubleArray(2 * corners.size) { if (it % 2 == 0) corners[it / 2].x else corners[it / 2].y }
        return physics.addPolygon(body, coordinates, Penbot.SHELL_FRICTION)
    }
}
