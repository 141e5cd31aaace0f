package robotran.learning.thorough

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.learning.unsolvedLessons
import robotran.learning.unsolvedWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class TwentySeedsTest {
    @Test
    fun `every solution of a lesson reaches the goals with 20 seeds`() = runTest(timeout = 30.minutes) {
        assertEquals(emptyList(), unsolvedLessons(BrickKind.RCX, 1..20))
    }

    @Test
    fun `every solution of a lesson for an NXT does, too`() = runTest(timeout = 30.minutes) {
        assertEquals(emptyList(), unsolvedLessons(BrickKind.NXT, 1..20))
    }

    @Test
    fun `every solution of a world reaches the goals with 20 seeds`() = runTest(timeout = 60.minutes) {
        assertEquals(emptyList(), unsolvedWorlds(1..20))
    }
}
