package robotran.nqc

import robotran.language.fuzz.Fuzzing
import robotran.legofirmware.image.FirmwareTarget
import kotlin.test.Test
import kotlin.test.assertTrue

class MutantsFuzzTest {
    @Test
    fun `programs that once found a fault neither crash nor hang the compiler`() {
        for (text in Fuzzing.corpusTexts(".nqc").values) {
            for (target in FirmwareTarget.entries) Mutants.compileWithoutHarm(text, NqcOptions(target, isOld = false))
        }
    }

    @Test
    fun `a hundred thousand changed programs never crash or hang the compiler`() {
        val sound = Fuzzing.count(MUTANTS) { Mutants(it).compileNext() }
        assertTrue(sound in Fuzzing.share(MUTANTS) / 50 until Fuzzing.share(MUTANTS), "$sound mutants compiled")
    }

    private companion object {
        const val MUTANTS = 100_000
    }
}
