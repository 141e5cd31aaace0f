package robotran.build.wasm

import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals

class CallMarksTest {
    private val module = sampleModule()

    @Test
    fun `a marked module has a byte for each function, which its first instruction sets`() {
        val marked = withCallMarks(module)
        assertEquals("called", marked.exports.last().name)
        val mark = byteArrayOf(0x41, 0, 0x41, 1, 0x3a, 0x40, 1, 1)
        assertContentEquals(byteArrayOf(1, 1, 0x7f) + mark + byteArrayOf(0x20, 0, 0x0b), marked.bodies[1])
        assertEquals(module.bodies.size, marked.bodies.size)
    }

    @Test
    fun `what reads memory and what copies much of it says where before`() {
        val marked = withCallMarks(moduleWithData(64, LargeData.LARGE))
        val mark = byteArrayOf(0x41, 0, 0x41, 1, 0x3a, 0x40, 1, 0)
        val copy = byteArrayOf(0x20, 0, 0x20, 1, 0x20, 2, 0x10, 3, 0x10, 0)
        val read = byteArrayOf(0x20, 0, 0x41, 3, 0x10, 2, 0x2d, 0, 3)
        assertContentEquals(byteArrayOf(0) + mark + copy + read + byteArrayOf(0x0b), marked.bodies[0])
        assertEquals(3, marked.bodies.size)
    }

    @Test
    fun `data that is large and at a constant address has marks`() {
        val data = LargeData.of(moduleWithData(64, LargeData.LARGE, LargeData.LARGE - 1, LargeData.LARGE + 1))
        val second = 1024 + 64 + 2 * LargeData.LARGE - 1
        assertEquals(
            listOf(Triple(1, 1024 + 64, LargeData.LARGE), Triple(3, second, LargeData.LARGE + 1)),
            data.map { Triple(it.index, it.address, it.size) },
        )
    }
}
