package robotran.ui.platform

import robotran.workshop.platform.OpeningMarks
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Marks as small files in [folder]. They are not flushed to the disk: they outlive the process, but not a machine that
 * loses its power, which is not the fault of what was opened.
 */
class FolderOpeningMarks(private val folder: Path) : OpeningMarks {
    override fun put(name: String, time: Long) = attempt {
        Files.createDirectories(folder)
        fileOf(name).writeText(time.toString())
    }

    override fun remove(name: String) = attempt { fileOf(name).deleteIfExists() }

    override fun timeOf(name: String): Long? = try {
        fileOf(name).takeIf { it.exists() }?.readText()?.toLongOrNull()
    } catch (_: IOException) {
        null
    }

    private fun fileOf(name: String): Path = folder.resolve("$name.mark")

    /** Where nothing can be written, nothing is marked. */
    private fun attempt(work: () -> Unit) = try {
        work()
    } catch (_: IOException) {
        Unit
    }
}
