package robotran.lejoslinker

import robotran.language.fuzz.Fuzzing
import kotlin.test.Test
import kotlin.test.assertTrue

class DamagedClassFilesFuzzTest {
    @Test
    fun `damaged class files never crash or hang the linker`() {
        val programs = Vectors.images.keys.filter { '.' !in it }
        val linked = Fuzzing.count(MUTANTS) { linkMutant(programs.random(it), it) is ImageResult.Success }
        assertTrue(linked > Fuzzing.share(MUTANTS) / 20, "only $linked mutants were sound enough to link")
    }

    private companion object {
        const val MUTANTS = 20_000
    }
}
