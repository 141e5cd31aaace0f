package robotran.legofirmware

import kotlin.test.Test
import kotlin.test.assertTrue

/** A tenth of what the JVM's fuzz tests try, on every target. */
class MutantsTest {
    @Test
    fun `damaged images neither crash nor hang nor grow`() {
        assertTrue(tryMutatedImages(IMAGES, seed = 1) > IMAGES / 4)
    }

    @Test
    fun `damaged assembly texts neither crash nor hang nor grow`() {
        assertTrue(tryMutatedTexts(TEXTS, seed = 2) > TEXTS / 50)
    }

    private companion object {
        const val IMAGES = 5_000
        const val TEXTS = 5_000
    }
}
