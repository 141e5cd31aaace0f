package robotran.nxt

import robotran.nxt.storage.FlashMemory
import robotran.nxt.storage.NxtFile
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertSame
import kotlin.test.assertTrue

class FlashMemoryTest {
    private fun file(name: String, size: Int, first: Int = 0) = NxtFile(name, ByteArray(size) { (it + first).toByte() })

    @Test
    fun `what it begins with is there`() {
        val files = listOf(file("log.txt", 300), file("empty", 0), NxtFile("é ÿ", byteArrayOf(1, -1), attributes = 2))
        val flash = FlashMemory(files)
        assertEquals(files, flash.files)
        assertSame(flash.files, flash.files)
        assertEquals(512 * 256 - 3 * 256 - 4 * 256, flash.freeBytes)
    }

    @Test
    fun `a page is kept until it is written again`() {
        val flash = FlashMemory()
        val page = ByteArray(256)
        assertTrue(flash.readPage(511, page))
        assertTrue(page.all { it.toInt() == -1 })
        assertTrue(flash.writePage(511, ByteArray(300) { 7 }))
        assertTrue(flash.readPage(511, page))
        assertTrue(page.all { it.toInt() == 7 })
        assertFalse(flash.writePage(512, page))
        assertFalse(flash.writePage(-1, page))
        assertFalse(flash.writePage(4, ByteArray(255)))
        assertFalse(flash.readPage(512, page))
        assertFalse(flash.readPage(4, ByteArray(255)))
    }

    @Test
    fun `a file that is deleted leaves its room to the others`() {
        val flash = FlashMemory(listOf(file("a", 1000), file("b", 600, first = 9)))
        flash.delete("a")
        assertEquals(listOf(file("b", 600, first = 9)), flash.files)
        assertEquals(512 * 256 - 3 * 256 - 3 * 256, flash.freeBytes)
        flash.delete("none")
        assertEquals(1, flash.files.size)
        flash.format()
        assertEquals(emptyList(), flash.files)
    }

    @Test
    fun `what does not fit is left out`() {
        val large = file("large", 100_000)
        assertEquals(listOf(large), FlashMemory(listOf(large, file("too large", 40_000), file("late", 1))).files)
        assertEquals(14, FlashMemory(List(30) { file("file$it.txt", 1) }).files.size)
        assertEquals(30, FlashMemory(List(40) { file("", 1) }).files.size)
    }

    @Test
    fun `a damaged table has no files or fewer`() {
        val flash = FlashMemory(listOf(file("a", 10), file("b", 10)))
        val table = ByteArray(256)
        flash.readPage(1, table)
        table[13] = -1 // the length of the first name
        flash.writePage(1, table)
        assertEquals(emptyList(), flash.files)
        flash.writePage(1, ByteArray(256) { 'V'.code.toByte() })
        assertEquals(emptyList(), flash.files)
    }

    @Test
    fun `files are equal if name and content are`() {
        assertEquals(file("a", 3), file("a", 3))
        assertEquals(file("a", 3).hashCode(), file("a", 3).hashCode())
        assertNotEquals(file("a", 3), file("b", 3))
        assertNotEquals(file("a", 3), file("a", 3, first = 1))
        val content = file("a", 3).content()
        assertContentEquals(byteArrayOf(0, 1, 2), content)
    }
}
