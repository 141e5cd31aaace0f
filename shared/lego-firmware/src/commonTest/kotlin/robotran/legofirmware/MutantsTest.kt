package robotran.legofirmware

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

/** Some of what the fuzz tests of the JVM try, on every target. */
class MutantsTest {
    @Test
    fun `damaged images neither crash nor hang nor grow`() {
        val random = Random(1)
        assertTrue((1..COUNT).count { tryMutatedImage(random) } > COUNT / 4)
    }

    @Test
    fun `damaged assembly texts neither crash nor hang nor grow`() {
        val random = Random(2)
        assertTrue((1..COUNT).count { tryMutatedText(random) } > COUNT / 50)
    }

    private companion object {
        const val COUNT = 1_000
    }
}
