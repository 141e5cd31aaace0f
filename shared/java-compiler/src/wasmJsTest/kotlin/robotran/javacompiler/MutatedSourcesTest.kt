package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

class MutatedSourcesTest {
    @Test
    fun `no program whatever makes the compiler fail`() = runTest(timeout = 5.minutes) { compileMutations(200) }
}
