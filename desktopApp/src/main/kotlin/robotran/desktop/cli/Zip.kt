package robotran.desktop.cli

import org.apache.commons.compress.archivers.zip.ZipArchiveEntry
import org.apache.commons.compress.archivers.zip.ZipArchiveOutputStream
import robotran.robolang.translate.KitFile
import java.io.ByteArrayOutputStream
import java.time.LocalDateTime
import java.util.zip.CRC32
import java.util.zip.ZipEntry

/**
 * [files] as a zip file: the same bytes for the same files, whenever and wherever it is made. They are not compressed, since that
 * differs between systems; a script can be run as it is unpacked.
 */
internal fun zip(files: List<KitFile>): ByteArray {
    val bytes = ByteArrayOutputStream()
    ZipArchiveOutputStream(bytes).use { zip ->
        for (file in files) {
            val content = file.text.encodeToByteArray()
            val entry = ZipArchiveEntry(file.path)
            entry.timeLocal = EARLIEST
            entry.unixMode = if (file.isExecutable) SCRIPT_MODE else FILE_MODE
            entry.method = ZipEntry.STORED
            entry.size = content.size.toLong()
            entry.crc = CRC32().apply { update(content) }.value
            zip.putArchiveEntry(entry)
            zip.write(content)
            zip.closeArchiveEntry()
        }
    }
    return bytes.toByteArray()
}

/** The first moment that zip files know. */
private val EARLIEST = LocalDateTime.of(1980, 1, 1, 0, 0)

/** What chmod calls 755 and 644, of a plain file. */
private const val SCRIPT_MODE = 0x81ED
private const val FILE_MODE = 0x81A4
