@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.simulation.physics

import kotlinx.coroutines.await
import robotran.world.geometry.Point
import robotran.world.geometry.Trigonometry

actual suspend fun loadPhysicsEngine(): PhysicsEngine = WasmPhysicsEngine(importPhysicsModule().await())

private class WasmPhysicsEngine(private val module: PhysicsModule) : PhysicsEngine {
    override val trigonometry = object : Trigonometry {
        override fun sine(angle: Double) = sineOf(angle)

        override fun cosine(angle: Double) = cosineOf(angle)

        override fun angle(x: Double, y: Double) = angleOf(x, y)
    }

    override fun createWorld(settings: PhysicsSettings): PhysicsWorld = with(settings) {
        WasmPhysicsWorld(
            module,
            module.createWorld(stepSeconds, stepParts, lengthTolerance, velocityIterations, positionIterations),
        )
    }
}

private class WasmPhysicsWorld(private val module: PhysicsModule, private val world: Int) : PhysicsWorld {
    override fun addBody(kind: Int, x: Double, y: Double, angle: Double) = module.addBody(world, kind, x, y, angle)

    override fun addPolygon(body: Int, corners: DoubleArray, friction: Double) =
        module.addPolygon(world, body, corners.toJsArray(), friction)

    override fun addCircle(body: Int, x: Double, y: Double, radius: Double, friction: Double) =
        module.addCircle(world, body, x, y, radius, friction)

    override fun spreadMass(body: Int, mass: Double) = module.spreadMass(world, body, mass)

    override fun addFloorFriction(body: Int, force: Double, torque: Double) =
        module.addFloorFriction(world, body, force, torque)

    override fun place(body: Int, x: Double, y: Double, angle: Double) = module.place(world, body, x, y, angle)

    override fun setMass(body: Int, x: Double, y: Double, mass: Double, inertia: Double) =
        module.setMass(world, body, x, y, mass, inertia)

    override fun applyImpulse(body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double) =
        applyImpulseTo(world, body, impulseX, impulseY, x, y)

    override fun step() = stepWorld(world)

    override fun isAtRest(body: Int) = isAtRestIn(world, body)

    override fun motion(body: Int) = BodyMotion(
        xOf(world, body),
        yOf(world, body),
        cosineOfBody(world, body),
        sineOfBody(world, body),
        velocityXOf(world, body),
        velocityYOf(world, body),
        angularVelocityOf(world, body),
    )

    override fun contacts(body: Int) = contactsOf(world, body)

    override fun freeDistance(body: Int, from: Point, to: Point) =
        freeDistanceIn(world, body, from.x, from.y, to.x, to.y)

    override fun ray(body: Int, from: Point, to: Point): RayHit? {
        val distance = rayIn(world, body, from.x, from.y, to.x, to.y)
        if (distance < 0) return null
        return RayHit(
            distance,
            rayNormalXIn(world),
            rayNormalYIn(world),
            rayMetCircleIn(world),
            rayBodyIn(world),
        )
    }

    override fun close() = module.closeWorld(world)
}
