package robotran.legofirmware

import robotran.language.fuzz.Fuzzing
import kotlin.test.Test
import kotlin.test.assertTrue

class MutantsFuzzTest {
    @Test
    fun `what once found a fault does no harm`() {
        Fuzzing.corpus(".rcx").values.forEach(::tryImage)
        Fuzzing.corpusTexts(".lasm").values.forEach(::tryText)
    }

    @Test
    fun `damaged images neither crash nor hang nor grow`() {
        assertTrue(Fuzzing.count(COUNT, ::tryMutatedImage) > Fuzzing.share(COUNT) / 4)
    }

    @Test
    fun `damaged assembly texts neither crash nor hang nor grow`() {
        assertTrue(Fuzzing.count(COUNT, ::tryMutatedText) > Fuzzing.share(COUNT) / 50)
    }

    private companion object {
        const val COUNT = 50_000
    }
}
