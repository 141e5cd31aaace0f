package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class LessonSeedsTest {
    @Test
    fun `every solution reaches the goals with other seeds, too`() = runTest(timeout = 5.minutes) {
        for (brick in BrickKind.entries) assertEquals(emptyList(), unsolvedLessons(brick, 2..3))
    }
}
