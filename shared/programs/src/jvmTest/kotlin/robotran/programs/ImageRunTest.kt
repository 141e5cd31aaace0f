package robotran.programs

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

/** The examples; `thorough` has all other programs. */
class ImageRunTest {
    @Test
    fun `images of the Java examples`() =
        runTest(timeout = 10.minutes) { ImageRuns().compare(lejosExamples, lejosExamples.size) }
}
