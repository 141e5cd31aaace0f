package robotran.workshop.export

import robotran.animatedpicture.AnimatedPictureLimits
import robotran.workshop.state.ShowSpeed
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class MovingPicturesTest {
    @Test
    fun `a short run is shown as fast as it was`() {
        assertEquals(listOf(ShowSpeed(1, 8), ShowSpeed(2, 4), ShowSpeed(4, 2)), speedsFor(7_400))
        assertEquals(ShowSpeed(1, 8), proposedSpeed(speedsFor(7_400)))
    }

    @Test
    fun `a longer run is shown faster, and slower if wanted`() {
        val speeds = speedsFor(42_000)
        assertEquals(listOf(42, 21, 11, 6), speeds.map { it.seconds })
        assertEquals(ShowSpeed(4, 11), proposedSpeed(speeds))
    }

    @Test
    fun `even the longest run fits into a minute and the limits of a moving picture`() {
        for (length in listOf(0L, 1, 59_999, 60_000, 60_001, 600_000, 3_600_000, 86_400_000)) {
            for (speed in speedsFor(length)) {
                assertTrue(speed.seconds <= 60, "$length at $speed")
                val frames = length / (80 * speed.factor) + 2
                assertTrue(frames <= AnimatedPictureLimits.MAX_FRAMES, "$length at $speed: $frames")
            }
        }
    }
}
