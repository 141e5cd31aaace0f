package robotran.ui.screen

import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.test.ExperimentalTestApi
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.withTimeoutOrNull
import javax.swing.SwingUtilities
import kotlin.test.Test
import kotlin.test.assertTrue

/** What a screen under test does, it does on the thread of its test: otherwise the two would race. */
@OptIn(ExperimentalTestApi::class)
class OneThreadTest {
    @Test
    fun `a limit of time in a screen does not end beside its test`() {
        var threads = emptyList<Thread>()
        undrawnTest(100, 100) {
            setContent {
                LaunchedEffect(Unit) {
                    threads += Thread.currentThread()
                    withTimeoutOrNull(1) { awaitCancellation() }
                    threads += Thread.currentThread()
                }
            }
            pass(100)
            assertTrue(threads.isNotEmpty())
            Thread.sleep(50) // Compose counts limits of time by the machine's clock.
            pass(100)
            assertTrue(SwingUtilities.isEventDispatchThread())
        }
        assertTrue(threads.all { it == threads.first() }, "$threads")
    }
}
