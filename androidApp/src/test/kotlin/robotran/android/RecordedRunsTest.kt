package robotran.android

import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import robotran.android.recorded.RecordedRuns
import java.io.File

/** The same runs as on the desktop and in the browser, with Android's classes. */
@RunWith(RobolectricTestRunner::class)
class RecordedRunsTest {
    @Test
    fun `all examples and projects make their recorded runs, trace hashes and all`() {
        val outcome = runBlocking { RecordedRuns(File(System.getProperty("robotran.tree"))).differences() }
        assertEquals("", outcome.differences.joinToString("\n"))
        assertTrue("$outcome", outcome.robolang > 0 && outcome.java > 0 && outcome.projects > 0)
    }
}
