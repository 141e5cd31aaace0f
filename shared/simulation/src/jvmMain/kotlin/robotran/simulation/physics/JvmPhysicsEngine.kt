package robotran.simulation.physics

import robotran.physics.RigidWorld
import robotran.world.geometry.Point
import robotran.world.geometry.Trigonometry
import robotran.physics.Trigonometry as JavaTrigonometry

actual suspend fun loadPhysicsEngine(): PhysicsEngine = JvmPhysicsEngine

private object JvmPhysicsEngine : PhysicsEngine {
    override val trigonometry = object : Trigonometry {
        override fun sine(angle: Double) = JavaTrigonometry.sine(angle)

        override fun cosine(angle: Double) = JavaTrigonometry.cosine(angle)

        override fun angle(x: Double, y: Double) = JavaTrigonometry.angle(x, y)
    }

    override fun createWorld(settings: PhysicsSettings): PhysicsWorld = with(settings) {
        JvmPhysicsWorld(RigidWorld(stepSeconds, stepParts, lengthTolerance, velocityIterations, positionIterations))
    }
}

private class JvmPhysicsWorld(private val world: RigidWorld) : PhysicsWorld {
    override fun addBody(kind: Int, x: Double, y: Double, angle: Double) = world.addBody(kind, x, y, angle)

    override fun addPolygon(body: Int, corners: DoubleArray, friction: Double) =
        world.addPolygon(body, corners, friction)

    override fun addCircle(body: Int, x: Double, y: Double, radius: Double, friction: Double) =
        world.addCircle(body, x, y, radius, friction)

    override fun spreadMass(body: Int, mass: Double) = world.spreadMass(body, mass)

    override fun addFloorFriction(body: Int, force: Double, torque: Double) =
        world.addFloorFriction(body, force, torque)

    override fun place(body: Int, x: Double, y: Double, angle: Double) = world.place(body, x, y, angle)

    override fun setMass(body: Int, x: Double, y: Double, mass: Double, inertia: Double) =
        world.setMass(body, x, y, mass, inertia)

    override fun applyImpulse(body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double) =
        world.applyImpulse(body, impulseX, impulseY, x, y)

    override fun step() = world.step()

    override fun isAtRest(body: Int) = world.isAtRest(body)

    override fun motion(body: Int) = BodyMotion(
        world.x(body),
        world.y(body),
        world.cosine(body),
        world.sine(body),
        world.velocityX(body),
        world.velocityY(body),
        world.angularVelocity(body),
    )

    override fun contacts(body: Int) = world.contacts(body)

    override fun freeDistance(body: Int, from: Point, to: Point) = world.freeDistance(body, from.x, from.y, to.x, to.y)

    override fun ray(body: Int, from: Point, to: Point): RayHit? {
        val distance = world.ray(body, from.x, from.y, to.x, to.y)
        if (distance < 0) return null
        return RayHit(distance, world.rayNormalX(), world.rayNormalY(), world.rayMetCircle(), world.rayBody())
    }

    override fun close() = Unit
}
