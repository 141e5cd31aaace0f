package robotran.workshop.programs

import kotlinx.coroutines.test.runTest
import robotran.programs.CompilerLoading
import robotran.workshop.state.ProgramReading
import kotlin.test.Test
import kotlin.test.assertEquals

class CompileSchedulerTest {
    private suspend fun readingAfter(readUnread: suspend () -> CompilerLoading): ProgramReading {
        var last = ProgramReading.WAITING
        CompileScheduler({ true }, readUnread, { 1 }) { last = it }.readAll()
        return last
    }

    @Test
    fun `programs that were compiled are done`() = runTest {
        assertEquals(ProgramReading.DONE, readingAfter { CompilerLoading.Loaded })
    }

    @Test
    fun `a compiler that could not be loaded is told as missing`() = runTest {
        assertEquals(
            ProgramReading.NO_COMPILER,
            readingAfter {
                CompilerLoading.Failed(IllegalStateException("offline"))
            },
        )
    }

    @Test
    fun `a bug of a compiler is not told as a missing one`() = runTest {
        assertEquals(ProgramReading.COMPILER_FAILED, readingAfter { error("a bug") })
    }
}
