package robotran.programs

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class NxtTranslatedExamplesTest {
    @Test
    fun `examples and their translations do the same on an NXT in a world`() = runTest(timeout = 10.minutes) {
        val comparison = NxtComparison().compare(robolangExamples)
        assertEquals("", comparison.differences.joinToString("\n"))
        assertTrue(comparison.compared >= 20, "only ${comparison.compared} programs were compared")
        assertTrue(comparison.ended >= 10, "only ${comparison.ended} programs ended")
    }
}
