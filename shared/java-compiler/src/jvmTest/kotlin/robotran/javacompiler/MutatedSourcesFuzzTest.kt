package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.fuzz.Fuzzing
import kotlin.test.Test
import kotlin.time.Duration.Companion.minutes

class MutatedSourcesFuzzTest {
    @Test
    fun `no program whatever makes the compiler fail`() = runTest(timeout = 10.minutes) {
        compileMutations(Fuzzing.share(2_000, atLeast = 300), Fuzzing.seed)
    }
}
