package robotran.simulation

import robotran.simulation.noise.NoiseStream
import robotran.simulation.robot.Bumper
import kotlin.test.Test
import kotlin.test.assertTrue

class BumperTest {
    @Test
    fun `a contact comes to rest as its bumper is however it has bounced`() {
        for (seed in 1..100) {
            val bumper = Bumper(NoiseStream(seed, "bumper"), realism = 1.0)
            repeat(100) { bumper.tick(touching = true) }
            assertTrue(bumper.isPressed && bumper.isClosed, "open with seed $seed")
            repeat(100) { bumper.tick(touching = false) }
            assertTrue(!bumper.isPressed && !bumper.isClosed, "closed with seed $seed")
        }
    }
}
