package robotran.assignments.collecting

import kotlinx.coroutines.test.runTest
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

class ZipReaderTest {
    private val text = "Ä text.\n".encodeToByteArray()
    private val zip = zipOf(listOf(ZipEntry("a/ä.txt", text), ZipEntry("b.bin", ByteArray(1000) { it.toByte() })))

    private fun entries(zip: ByteArray) = assertIs<ZipReading.Read>(readZip(zip)).entries

    @Test
    fun `stored files come out as they were put in`() = runTest {
        assertEquals(listOf("a/ä.txt", "b.bin"), entries(zip).map { it.path })
        assertContentEquals(text, entries(zip).first().content(100))
        assertNull(entries(zip).first().content(5))
    }

    @Test
    fun `something may stand before a zip and after it`() = runTest {
        val around = ByteArray(500) { 7 } + zip
        assertContentEquals(text, entries(around).first().content(100))
    }

    @Test
    fun `large zips and other files are refused`() {
        assertEquals(ZipReading.Broken, readZip(ByteArray(0)))
        assertEquals(ZipReading.Broken, readZip(ByteArray(100)))
        assertEquals(ZipReading.Broken, readZip(zip.dropLast(1).toByteArray()))
        val zip64 = zip.copyOf().also { for (place in zip.size - 6..zip.size - 3) it[place] = -1 }
        assertEquals(ZipReading.Zip64, readZip(zip64))
        val many = zip.copyOf().also { it[zip.size - 12 + 1] = 100 }
        assertEquals(ZipReading.TooManyEntries, readZip(many))
    }

    @Test
    fun `no damage makes reading fail`() = runTest {
        val random = Random(4)
        repeat(3_000) {
            val damaged = zip.copyOf()
            repeat(random.nextInt(1, 6)) { damaged[random.nextInt(damaged.size)] = random.nextInt().toByte() }
            val cut = if (random.nextInt(4) == 0) damaged.copyOf(random.nextInt(damaged.size)) else damaged
            (readZip(cut) as? ZipReading.Read)?.entries?.forEach { it.content(2_000) }
        }
    }
}
