package robotran.nqc

import kotlin.test.Test
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds
import kotlin.time.measureTime

class MutantsFuzzTest {
    @Test
    fun `a hundred thousand changed programs never crash or hang the compiler`() {
        val mutants = Mutants(seed = 4)
        val longest = (1..MUTANTS).maxOf { measureTime { mutants.compileNext() } }
        assertTrue(longest < LIMIT, "a program took $longest")
    }

    private companion object {
        const val MUTANTS = 100_000
        val LIMIT = 10.seconds
    }
}
