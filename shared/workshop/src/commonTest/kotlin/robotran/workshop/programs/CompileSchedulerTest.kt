package robotran.workshop.programs

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.currentTime
import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals

@OptIn(ExperimentalCoroutinesApi::class)
class CompileSchedulerTest {
    private val scheduler = CompileScheduler()

    /** The virtual time in milliseconds at which a compilation starts if [change] happens meanwhile. */
    private suspend fun TestScope.startOfCompile(change: suspend CoroutineScope.() -> Unit): Long {
        val changes = launch { change() }
        scheduler.awaitCompile()
        changes.cancel()
        return currentTime
    }

    @Test
    fun `a program is compiled once typing pauses`() = runTest {
        val start = startOfCompile {
            repeat(3) {
                scheduler.requestCompile(characters = 0)
                delay(200)
            }
        }
        assertEquals(2 * 200 + 300, start)
    }

    @Test
    fun `a long program waits for a longer pause`() = runTest {
        assertEquals(300 + 100, startOfCompile { scheduler.requestCompile(characters = 15_000) })
    }

    @Test
    fun `a caller that waits does not wait for a pause`() = runTest {
        scheduler.requestCompile(characters = 15_000)
        assertEquals(0, startOfCompile { scheduler.requestCompileNow() })
    }

    @Test
    fun `after a hurried compilation the next change waits for a pause again`() = runTest {
        startOfCompile { scheduler.requestCompileNow() }
        assertEquals(300, startOfCompile { scheduler.requestCompile(characters = 0) })
    }
}
