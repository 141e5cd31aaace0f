package robotran.ui.world

import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DanceTest {
    private val angles = (0..240).map { danceAngle(it / 240f) }

    @Test
    fun `a robot dances to both sides and ends as it began`() {
        assertTrue(angles.max() > 10 && angles.min() < -10)
        assertEquals(listOf(0.0, 0.0), listOf(angles.first(), angles.last()))
    }

    @Test
    fun `it calms down and never jumps`() {
        assertTrue(angles.take(60).maxOf { abs(it) } > 2 * angles.takeLast(60).maxOf { abs(it) })
        assertTrue(angles.zipWithNext().all { (before, after) -> abs(after - before) < 3 })
    }
}
