package robotran.programs.thorough

import kotlinx.coroutines.test.runTest
import robotran.programs.NxtTranslatedPoses
import robotran.programs.TranslatedPoses
import robotran.programs.TranslationDifferences
import robotran.programs.robolangExamples
import robotran.programs.robolangPrograms
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

/** All Robolang programs and examples against their translations. */
class EveryTranslationTest {
    @Test
    fun `every program and its translation make the same calls at the same times`() = runTest(timeout = 10.minutes) {
        TranslationDifferences().compareCalls(share = 1, min = 200)
    }

    @Test
    fun `every program with behaviours and its translation make the same calls one after the other`() =
        runTest(timeout = 10.minutes) {
            TranslationDifferences().compareBehaviours(share = 1, min = 20)
        }

    @Test
    fun `the translation of every program leaves the robot at the same place`() = runTest(timeout = 10.minutes) {
        TranslatedPoses().compare(robolangExamples + robolangPrograms, min = 150)
    }

    @Test
    fun `the translation of every program leaves a robot with an NXT at the same place`() =
        runTest(timeout = 10.minutes) {
            NxtTranslatedPoses().compare(robolangExamples + robolangPrograms, min = 100)
        }
}
