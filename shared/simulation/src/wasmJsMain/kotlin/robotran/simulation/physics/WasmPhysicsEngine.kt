@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.simulation.physics

import kotlinx.coroutines.await
import robotran.world.geometry.Point
import robotran.world.geometry.Trigonometry

actual suspend fun loadPhysicsEngine(): PhysicsEngine = WasmPhysicsEngine(importPhysicsModule().await())

private class WasmPhysicsEngine(private val module: PhysicsModule) : PhysicsEngine {
    override val trigonometry = object : Trigonometry {
        override fun sine(angle: Double) = module.sineOf(angle)

        override fun cosine(angle: Double) = module.cosineOf(angle)

        override fun angle(x: Double, y: Double) = module.angleOf(x, y)
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
        module.applyImpulse(world, body, impulseX, impulseY, x, y)

    override fun step() = module.step(world)

    override fun motion(body: Int) = BodyMotion(
        module.x(world, body),
        module.y(world, body),
        module.cosine(world, body),
        module.sine(world, body),
        module.velocityX(world, body),
        module.velocityY(world, body),
        module.angularVelocity(world, body),
    )

    override fun contacts(body: Int) = module.contacts(world, body)

    override fun freeDistance(body: Int, from: Point, to: Point) =
        module.freeDistance(world, body, from.x, from.y, to.x, to.y)

    override fun close() = module.closeWorld(world)
}
