package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.simulation.config.SimulationLimits
import robotran.simulation.physics.BodyMotion
import robotran.simulation.physics.PhysicsWorld
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class RestTest {
    @Test
    fun `a block rests until something touches it, and again when it has come to a stand`() = runTest {
        val table = Table(loadPhysicsEngine().createWorld(SimulationLimits.PHYSICS))
        repeat(3) { table.physics.step() }
        assertTrue(table.physics.isAtRest(table.near))
        table.push()
        while (table.physics.motion(table.near).x == NEAR) table.physics.step()
        assertFalse(table.physics.isAtRest(table.near))
        assertTrue(table.physics.isAtRest(table.far), "nothing has touched it yet")
        repeat(LONG) { table.physics.step() }
        assertTrue(table.physics.motion(table.far).x > FAR)
        assertTrue(table.physics.isAtRest(table.far))
    }

    @Test
    fun `blocks that have rested are pushed in the same way as blocks that never could`() = runTest {
        val engine = loadPhysicsEngine()
        val resting = Table(engine.createWorld(SimulationLimits.PHYSICS))
        val awake = Table(engine.createWorld(SimulationLimits.PHYSICS))
        repeat(LONG) { step ->
            if (step == 5) for (table in listOf(resting, awake)) table.push()
            awake.keepBlocksAwake()
            for (table in listOf(resting, awake)) table.physics.step()
            assertEquals(awake.motions(), resting.motions(), "step $step")
        }
        assertTrue(resting.motions().none { it.x == NEAR || it.x == FAR }, "all have been pushed")
    }

    /** A pusher, and two blocks in its way. */
    private class Table(val physics: PhysicsWorld) {
        val near = block(NEAR)
        val far = block(FAR)
        val pusher = body(0.0).also { physics.setMass(it, 0.0, 0.0, 1.0, 1.0) }

        fun push() = physics.applyImpulse(pusher, 300.0, 4.0, 0.0, 0.5)

        fun motions(): List<BodyMotion> = listOf(near, far, pusher).map(physics::motion)

        /** Puts blocks that nothing has moved where they are, which wakes them. */
        fun keepBlocksAwake() {
            for ((block, x) in listOf(near to NEAR, far to FAR)) {
                if (physics.motion(block).x == x) physics.place(block, x, 0.0, 0.0)
            }
        }

        private fun block(x: Double) = body(x).also {
            physics.spreadMass(it, 0.2)
            physics.addFloorFriction(it, 40.0, 60.0)
        }

        private fun body(x: Double): Int {
            val body = physics.addBody(0, x, 0.0, 0.0)
            physics.addPolygon(body, doubleArrayOf(-2.0, -2.0, 2.0, -2.0, 2.0, 2.0, -2.0, 2.0), 0.4)
            return body
        }
    }

    private companion object {
        const val NEAR = 8.0
        const val FAR = 14.5
        const val LONG = 2_000
    }
}
