package robotran.workshop.programs

import kotlinx.coroutines.test.runTest
import robotran.programs.CompilerLoading
import robotran.workshop.state.CompileStatus
import kotlin.coroutines.cancellation.CancellationException
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class CompileResultTest {
    @Test
    fun `compiled programs are done`() = runTest {
        assertEquals(CompileStatus.DONE, resultOf { CompilerLoading.Success })
    }

    @Test
    fun `a compiler that cannot be loaded is reported as missing`() = runTest {
        val loading = CompilerLoading.Failure(IllegalStateException("offline"))
        assertEquals(CompileStatus.NO_COMPILER, resultOf { loading })
    }

    @Test
    fun `a bug of a compiler is not reported as a missing compiler`() = runTest {
        assertEquals(CompileStatus.COMPILER_FAILED, resultOf { error("a bug") })
    }

    @Test
    fun `cancelling the compilation is not a bug`() = runTest {
        assertFailsWith<CancellationException> { resultOf { throw CancellationException() } }
    }
}
