package robotran.tower.transfer

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BlockSizeTest {
    private val size = BlockSize()

    @Test
    fun `a block that had to be sent three times makes the next one smaller`() {
        size.confirmed(attempts = 3)
        assertEquals(100, size.bytes)
        repeat(10) { size.confirmed(attempts = 5) }
        assertEquals(8, size.bytes)
        assertTrue(size.isSmallest)
    }

    @Test
    fun `four blocks in a row at once make the next one larger`() {
        size.smaller()
        size.smaller()
        repeat(3) { size.confirmed(attempts = 1) }
        size.confirmed(attempts = 2)
        repeat(3) { size.confirmed(attempts = 1) }
        assertEquals(50, size.bytes)
        size.confirmed(attempts = 1)
        assertEquals(100, size.bytes)
        repeat(100) { size.confirmed(attempts = 1) }
        assertEquals(200, size.bytes)
    }
}
