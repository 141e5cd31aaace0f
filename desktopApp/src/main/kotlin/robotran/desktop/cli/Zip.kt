package robotran.desktop.cli

import robotran.robolang.translate.KitFile
import java.io.ByteArrayOutputStream
import java.time.LocalDateTime
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/** [files] as a zip file: the same bytes for the same files, whenever and wherever it is made. */
internal fun zip(files: List<KitFile>): ByteArray {
    val bytes = ByteArrayOutputStream()
    ZipOutputStream(bytes).use { zip ->
        for (file in files) {
            val entry = ZipEntry(file.path)
            entry.timeLocal = EARLIEST
            zip.putNextEntry(entry)
            zip.write(file.text.encodeToByteArray())
            zip.closeEntry()
        }
    }
    return bytes.toByteArray()
}

/** The first moment that zip files know. */
private val EARLIEST = LocalDateTime.of(1980, 1, 1, 0, 0)
