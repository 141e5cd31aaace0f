package robotran.programs.thorough

import kotlinx.coroutines.test.runTest
import robotran.programs.ImageRuns
import robotran.programs.libraryPrograms
import robotran.programs.robolangExamples
import robotran.programs.robolangOf
import robotran.programs.robolangPrograms
import robotran.programs.sensorsIn
import robotran.robolang.translate.translateRobolang
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

class EveryImageRunTest {
    @Test
    fun `images of the test programs`() =
        runTest(timeout = 10.minutes) { ImageRuns().compare(libraryPrograms, min = 100) }

    @Test
    fun `images of what Robolang programs become`() = runTest(timeout = 10.minutes) {
        val translations = (robolangExamples + robolangPrograms).mapNotNull { (path, text) ->
            robolangOf(path, text)?.let { translateRobolang(it) }?.let {
                "$path/${it.fileName}" to
                    it.java + commentsOf(text)
            }
        }
        ImageRuns().compare(translations.toMap(), min = 200)
    }

    /** Sensors that the Robolang program expects, for the Java that it becomes. */
    private fun commentsOf(text: String) = sensorsIn(text).joinToString("") {
        "\n// sensor ${it.port} at ${it.milliseconds}: raw ${it.raw}"
    }
}
