package robotran.legofirmware

import kotlin.test.Test
import kotlin.test.assertTrue

class MutantsFuzzTest {
    @Test
    fun `damaged images neither crash nor hang nor grow`() {
        assertTrue(tryMutatedImages(COUNT, seed = 3) > COUNT / 4)
    }

    @Test
    fun `damaged assembly texts neither crash nor hang nor grow`() {
        assertTrue(tryMutatedTexts(COUNT, seed = 4) > COUNT / 50)
    }

    private companion object {
        const val COUNT = 50_000
    }
}
