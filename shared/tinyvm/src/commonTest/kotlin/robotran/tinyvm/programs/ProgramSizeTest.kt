package robotran.tinyvm.programs

import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.BrickRoom
import kotlin.test.Test
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ProgramSizeTest {
    private fun freeBytes(path: String): Int =
        BrickRoom.V3_0.bytes - assertIs<TinyVmResult.Success>(link(path), path).program.linked.bytes

    @Test
    fun `a small program leaves twelve thousand bytes for its objects`() {
        val free = freeBytes("rcx/PaperSample.java")
        assertTrue(free in 12_000..13_500, "$free are free")
    }

    @Test
    fun `a program with behaviours leaves less`() {
        val free = freeBytes("robotics/ArbitratorChooses.java")
        assertTrue(free in 6_000 until freeBytes("rcx/PaperSample.java"), "$free are free")
    }
}
