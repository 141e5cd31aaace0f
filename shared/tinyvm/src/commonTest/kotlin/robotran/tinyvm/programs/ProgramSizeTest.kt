package robotran.tinyvm.programs

import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmLimits
import kotlin.test.Test
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ProgramSizeTest {
    private fun freeBytes(path: String): Int =
        TinyVmLimits.MEMORY_BYTES - assertIs<TinyVmResult.Ready>(link(path), path).program.linked.bytes

    @Test
    fun `a small program leaves ten thousand bytes for its objects`() {
        val free = freeBytes("rcx/PaperSample.java")
        assertTrue(free in 10_000..11_500, "$free are free")
    }

    @Test
    fun `a program with behaviours leaves less`() {
        val free = freeBytes("robotics/ArbitratorChooses.java")
        assertTrue(free in 6_000 until freeBytes("rcx/PaperSample.java"), "$free are free")
    }
}
