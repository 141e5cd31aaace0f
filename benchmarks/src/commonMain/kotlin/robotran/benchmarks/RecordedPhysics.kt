package robotran.benchmarks

import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.PhysicsSettings
import robotran.simulation.physics.PhysicsWorld
import robotran.world.geometry.Point

/** Physics that records a session's calls, to repeat the physics steps without the session. */
internal class RecordedPhysics(private val engine: PhysicsEngine) : PhysicsEngine by engine {
    private var settings: PhysicsSettings? = null
    private val building = mutableListOf<(PhysicsWorld) -> Unit>()
    private val steps = mutableListOf<List<(PhysicsWorld) -> Unit>>()
    private val pushes = mutableListOf<(PhysicsWorld) -> Unit>()

    override fun createWorld(settings: PhysicsSettings): PhysicsWorld {
        this.settings = settings
        return Recorder(engine.createWorld(settings))
    }

    /** Repeats all recorded calls. */
    fun again() {
        val world = engine.createWorld(checkNotNull(settings))
        for (part in building) part(world)
        for (step in steps) {
            for (push in step) push(world)
            world.step()
        }
        world.close()
    }

    private inner class Recorder(private val world: PhysicsWorld) : PhysicsWorld by world {
        override fun addBody(kind: Int, x: Double, y: Double, angle: Double): Int =
            also { it.addBody(kind, x, y, angle) }

        override fun addPolygon(body: Int, corners: DoubleArray, friction: Double): Int = also {
            it.addPolygon(body, corners, friction)
        }

        override fun addCircle(body: Int, x: Double, y: Double, radius: Double, friction: Double): Int =
            also { it.addCircle(body, x, y, radius, friction) }

        override fun setMass(body: Int, x: Double, y: Double, mass: Double, inertia: Double) = also {
            it.setMass(body, x, y, mass, inertia)
        }

        override fun spreadMass(body: Int, mass: Double) = also { it.spreadMass(body, mass) }

        override fun addFloorFriction(body: Int, force: Double, torque: Double) = also {
            it.addFloorFriction(body, force, torque)
        }

        override fun applyImpulse(body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double) {
            pushes += { it.applyImpulse(body, impulseX, impulseY, x, y) }
            world.applyImpulse(body, impulseX, impulseY, x, y)
        }

        override fun step() {
            steps += pushes.toList()
            pushes.clear()
            world.step()
        }

        override fun freeDistance(body: Int, from: Point, to: Point): Double = world.freeDistance(body, from, to)

        override fun ray(body: Int, from: Point, to: Point) = world.ray(body, from, to)

        private fun <T> also(part: (PhysicsWorld) -> T): T {
            building += { part(it) }
            return part(world)
        }
    }
}
