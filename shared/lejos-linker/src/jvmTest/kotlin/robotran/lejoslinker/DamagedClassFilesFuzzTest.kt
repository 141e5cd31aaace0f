package robotran.lejoslinker

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class DamagedClassFilesFuzzTest {
    @Test
    fun `damaged class files never crash or hang the linker`() {
        val random = Random(7)
        val programs = Vectors.images.keys.filter { '.' !in it }
        val linked = (1..MUTANTS).count {
            val program = programs.random(random)
            linkMutant(program, random) is ImageResult.Linked
        }
        assertTrue(linked > MUTANTS / 20, "only $linked mutants were sound enough to link")
    }

    private companion object {
        const val MUTANTS = 20_000
    }
}
