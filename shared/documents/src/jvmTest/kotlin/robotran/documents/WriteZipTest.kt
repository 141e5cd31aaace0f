package robotran.documents

import kotlinx.coroutines.runBlocking
import robotran.projects.deflate
import java.io.ByteArrayInputStream
import java.util.zip.ZipInputStream
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals

/** Java's own reader, which checks lengths and checksums, accepts our zip files. */
class WriteZipTest {
    @Test
    fun `every file comes out as it was put in`() {
        val entries = listOf(
            ZipEntry("Square/Square.java", "class Square {}\n".encodeToByteArray()),
            ZipEntry("Square/download.sh", ByteArray(100_000) { it.toByte() }, isExecutable = true),
            ZipEntry("Square/ñ.robo", byteArrayOf()),
            ByteArray(100_000).let { ZipEntry("zeros", it, deflated = runBlocking { deflate(it) }) },
        )
        ZipInputStream(ByteArrayInputStream(zipOf(entries))).use { zip ->
            for (entry in entries) {
                assertEquals(entry.path, zip.nextEntry?.name)
                assertContentEquals(entry.bytes, zip.readBytes())
            }
            assertEquals(null, zip.nextEntry)
        }
    }
}
