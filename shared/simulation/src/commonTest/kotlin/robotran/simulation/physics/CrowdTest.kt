package robotran.simulation.physics

import kotlinx.coroutines.test.runTest
import robotran.simulation.config.SimulationLimits
import robotran.simulation.config.TraceHash
import robotran.simulation.noise.NoiseStream
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

/** Compares crowds of bodies with the same crowds in dyn4j's own `World`, whose results are recorded here. */
class CrowdTest {
    private val recorded = listOf(
        "bb30e3c114cef20e",
        "60345d0566b7e3d0",
        "a84944b74c27063f",
        "428bd7909b1a37e0",
        "a9a304f061a580ae",
    )

    @Test
    fun `bodies that push each other move as in the world of dyn4j`() = runTest(timeout = 5.minutes) {
        val engine = loadPhysicsEngine()
        assertEquals(recorded, List(5) { Crowd(engine.createWorld(SimulationLimits.PHYSICS), it + 1).run() })
    }

    private class Crowd(private val physics: PhysicsWorld, number: Int) {
        private val random = NoiseStream(number, "crowd")

        /** Every other crowd stands on whole numbers, where many distances are equal. */
        private val isEven = number % 2 == 0
        private val hash = TraceHash()

        init {
            repeat(12) { shape(body(kind = 1)) }
        }

        private val blocks = List(12) {
            body(kind = 2).also { block ->
                shape(block)
                val mass = from(0.05, 0.4)
                physics.spreadMass(block, mass)
                physics.addFloorFriction(block, 400 * mass, 800 * mass)
            }
        }
        private val pushers = List(4) {
            body(kind = 3).also { pusher ->
                box(pusher, -5.0, 0.0, 4.0, 8.0)
                box(pusher, 4.0, 2.5, 6.0, 3.0)
                box(pusher, 4.0, -2.5, 6.0, 3.0)
                physics.setMass(pusher, 1.0, 0.0, 0.6, 9.0)
            }
        }

        fun run(): String {
            repeat(STEPS) { step ->
                if (step % 40 == 0) pushers.forEach(::push)
                if (step % 50 == 0) blocks[any(blocks.size)].let { physics.place(it, place(), place(), 0.0) }
                if (step % 170 == 0) pushers[any(pushers.size)].let { physics.place(it, place(), place(), 1.0) }
                pushers.forEach(::look)
                physics.step()
                (blocks + pushers).forEach(::add)
            }
            physics.close()
            return hash.text
        }

        private fun push(pusher: Int) = with(physics.motion(pusher)) {
            physics.applyImpulse(pusher, from(-20.0, 20.0), from(-20.0, 20.0), x + from(-2.0, 2.0), y)
        }

        private fun look(pusher: Int) = with(physics.motion(pusher)) {
            val eye = Point(x + 7 * cosine, y + 7 * sine)
            hash.add(physics.freeDistance(pusher, eye, Point(SIDE / 2, SIDE / 2)).toRawBits())
            hash.add(physics.freeDistance(pusher, eye, Point(x + 40 * cosine, y + 40 * sine)).toRawBits())
        }

        private fun add(body: Int) = with(physics.motion(body)) {
            for (value in listOf(x, y, cosine, sine, velocityX, velocityY, angularVelocity)) hash.add(value.toRawBits())
            hash.add(physics.contacts(body).toLong())
        }

        private fun body(kind: Int) = physics.addBody(kind, place(), place(), 0.0)

        private fun shape(body: Int) {
            val size = if (isEven) 2.0 + any(4) else from(1.5, 6.0)
            when (any(3)) {
                0 -> physics.addCircle(body, 0.0, 0.0, size / 2, FRICTION)
                1 -> box(body, -size, 0.0, size, size)

                // Concave.
                else -> physics.addPolygon(
                    body,
                    doubleArrayOf(0.0, 0.0, size, 0.0, size * 0.4, size * 0.3, 0.0, size),
                    FRICTION,
                )
            }
        }

        private fun box(body: Int, back: Double, middle: Double, front: Double, width: Double) {
            val right = middle - width / 2
            val left = middle + width / 2
            physics.addPolygon(body, doubleArrayOf(back, right, front, right, front, left, back, left), FRICTION)
        }

        private fun place() = if (isEven) 2.0 * any((SIDE / 2).toInt()) else from(0.0, SIDE)

        private fun any(count: Int) = (random.share() * count).toInt()

        private fun from(low: Double, high: Double) = low + (high - low) * random.share()
    }

    private companion object {
        const val SIDE = 60.0
        const val STEPS = 1_500
        const val FRICTION = 0.3
    }
}
