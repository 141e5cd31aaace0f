package robotran.robolang.translate

import robotran.robolang.recordedTranslations
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Detects any change in the generated Java, on every target. */
class RecordedTranslationTest {
    @Test
    fun `each recorded program becomes the recorded Java`() {
        val programs = recordedTranslations.filterKeys { it.endsWith(PROGRAM) }
        assertTrue(programs.size >= 6, "only ${programs.size} recorded programs were found")
        for ((name, source) in programs) {
            assertEquals(
                recordedTranslations[name.removeSuffix(PROGRAM) + ".java.txt"],
                translationOf(source, name).java,
                name,
            )
        }
    }

    private companion object {
        const val PROGRAM = ".robo"
    }
}
