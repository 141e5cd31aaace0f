package robotran.programs.thorough

import kotlinx.coroutines.test.runTest
import robotran.programs.NxtComparison
import robotran.programs.NxtTranslatedExamplesTest
import robotran.programs.robolangPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** The same as [NxtTranslatedExamplesTest] with the test programs of Robolang. */
class NxtTranslatedProgramsTest {
    @Test
    fun `test programs and their translations do the same on an NXT in a world`() = runTest(timeout = 20.minutes) {
        val comparison = NxtComparison().compare(robolangPrograms)
        assertEquals("", comparison.differences.joinToString("\n"))
        assertTrue(comparison.compared >= 230, "only ${comparison.compared} programs were compared")
        assertTrue(comparison.ended >= 140, "only ${comparison.ended} programs ended")
    }
}
