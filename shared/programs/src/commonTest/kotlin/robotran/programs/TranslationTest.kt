package robotran.programs

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

/**
 * A share of the Robolang programs against their translations, on every target. Recorded runs show that each machine
 * does the same everywhere, so the JVM alone compares all programs (`EveryTranslationTest`): a browser's compiler
 * takes ten times as long.
 */
class TranslationTest {
    @Test
    fun aProgramAndItsTranslationMakeTheSameCallsAtTheSameTimes() = runTest(timeout = 10.minutes) {
        TranslationDifferences().compareCalls(SHARE, min = 25)
    }

    @Test
    fun aProgramWithBehavioursAndItsTranslationMakeTheSameCallsOneAfterTheOther() = runTest(timeout = 10.minutes) {
        TranslationDifferences().compareBehaviours(SHARE, min = 2)
    }

    @Test
    fun aTranslationLeavesTheRobotAtTheSamePlace() = runTest(timeout = 10.minutes) {
        TranslatedPoses().compare(someTexts, min = 18)
    }

    @Test
    fun aTranslationLeavesARobotWithAnNxtAtTheSamePlace() = runTest(timeout = 10.minutes) {
        NxtTranslatedPoses().compare(someTexts, min = 12)
    }

    private companion object {
        const val SHARE = 8

        val someTexts = (robolangExamples + robolangPrograms).entries.toList().every(SHARE).associate { it.toPair() }
    }
}
