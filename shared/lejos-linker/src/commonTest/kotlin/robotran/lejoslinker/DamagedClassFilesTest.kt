package robotran.lejoslinker

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class DamagedClassFilesTest {
    @Test
    fun `a few hundred damaged class files never crash the linker`() {
        val random = Random(8)
        val linked = (1..MUTANTS).count { linkMutant("Patrol", random) is ImageResult.Success }
        assertTrue(linked in MUTANTS / 20 until MUTANTS, "$linked mutants were linked")
    }

    private companion object {
        const val MUTANTS = 300
    }
}
