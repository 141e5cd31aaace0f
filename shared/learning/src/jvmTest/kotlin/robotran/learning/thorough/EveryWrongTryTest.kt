package robotran.learning.thorough

import kotlinx.coroutines.test.runTest
import robotran.learning.allWrongTries
import robotran.learning.checkHints
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

class EveryWrongTryTest {
    @Test
    fun `no wrong try reaches the goals, and nine of ten get the hint that is meant`() = runTest(timeout = 10.minutes) {
        checkHints(allWrongTries)
    }
}
