package robotran.simulation.physics

import kotlinx.coroutines.test.runTest
import robotran.simulation.config.SimulationLimits
import robotran.world.geometry.Point
import robotran.world.geometry.RADIANS_PER_DEGREE
import kotlin.math.sqrt
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

/** A ray tells what it meets, the same on every target. */
class RayTest {
    private val square = doubleArrayOf(-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0)

    @Test
    fun `it meets the side of a turned square`() = runTest {
        val world = loadPhysicsEngine().createWorld(SimulationLimits.PHYSICS)
        val body = world.addBody(0, 10.0, 0.0, 30 * RADIANS_PER_DEGREE)
        world.addPolygon(body, square, 0.3)
        val hit = assertNotNull(world.ray(-1, Point(0.0, 0.0), Point(50.0, 0.0)))
        assertEquals(body, hit.body)
        assertEquals(false, hit.isRound)
        assertEquals(10 - 2 / sqrt(3.0), hit.distance, 1e-6)
        assertEquals(-sqrt(3.0) / 2, hit.normalX, 1e-9)
        assertEquals(-0.5, hit.normalY, 1e-9)
        assertEquals(hit.distance, world.freeDistance(-1, Point(0.0, 0.0), Point(50.0, 0.0)))
        world.close()
    }

    @Test
    fun `it meets a circle and the nearest of two things`() = runTest {
        val world = loadPhysicsEngine().createWorld(SimulationLimits.PHYSICS)
        val far = world.addBody(0, 20.0, 0.0, 0.0)
        world.addPolygon(far, square, 0.3)
        val near = world.addBody(0, 10.0, 0.6, 0.0)
        world.addCircle(near, 0.0, 0.0, 1.0, 0.3)
        val hit = assertNotNull(world.ray(-1, Point(0.0, 0.0), Point(50.0, 0.0)))
        assertEquals(near, hit.body)
        assertEquals(true, hit.isRound)
        assertEquals(9.2, hit.distance, 1e-6)
        assertEquals(-0.8, hit.normalX, 1e-6)
        assertEquals(-0.6, hit.normalY, 1e-6)
        assertEquals(far, world.ray(near, Point(0.0, 0.0), Point(50.0, 0.0))?.body)
        world.close()
    }

    @Test
    fun `it meets nothing that is not there`() = runTest {
        val world = loadPhysicsEngine().createWorld(SimulationLimits.PHYSICS)
        world.addPolygon(world.addBody(0, 10.0, 5.0, 0.0), square, 0.3)
        assertEquals(null, world.ray(-1, Point(0.0, 0.0), Point(50.0, 0.0)))
        assertEquals(null, world.ray(-1, Point(0.0, 0.0), Point(8.9, 5.0)))
        assertEquals(null, world.ray(-1, Point(10.0, 5.0), Point(10.0, 5.0)))
        world.close()
    }
}
