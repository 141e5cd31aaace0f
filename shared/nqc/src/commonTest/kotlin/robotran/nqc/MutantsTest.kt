package robotran.nqc

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class MutantsTest {
    @Test
    fun `two thousand changed programs never crash the compiler`() {
        val mutants = Mutants(Random(3))
        val sound = (1..MUTANTS).count { mutants.compileNext() }
        assertTrue(sound in MUTANTS / 50 until MUTANTS, "$sound mutants compiled")
    }

    private companion object {
        const val MUTANTS = 2_000
    }
}
