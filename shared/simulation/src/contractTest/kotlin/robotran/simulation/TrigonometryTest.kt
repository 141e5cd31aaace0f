package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.simulation.config.TraceHash
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.math.PI
import kotlin.test.Test
import kotlin.test.assertEquals

class TrigonometryTest {
    @Test
    fun `angles and their sines and cosines belong together`() = runTest {
        val trigonometry = loadPhysicsEngine().trigonometry
        for (degrees in -179..180) {
            val angle = degrees * PI / 180
            assertEquals(angle, trigonometry.angle(trigonometry.cosine(angle), trigonometry.sine(angle)), 1e-14)
        }
    }

    @Test
    fun `straight back is a positive half turn from either side`() = runTest {
        val trigonometry = loadPhysicsEngine().trigonometry
        assertEquals(PI, trigonometry.angle(-1.0, 0.0))
        assertEquals(PI, trigonometry.angle(-1.0, -0.0))
    }

    @Test
    fun `the last bits are the same on every target`() = runTest {
        val trigonometry = loadPhysicsEngine().trigonometry
        val hash = TraceHash()
        var angle = -7.0
        repeat(2000) {
            hash.add(trigonometry.sine(angle).toRawBits())
            hash.add(trigonometry.cosine(angle).toRawBits())
            hash.add(trigonometry.angle(angle, 1.5).toRawBits())
            angle += 0.007
        }
        assertEquals("c94cf35013cd54c3", hash.text)
    }
}
