package robotran.desktoptower.microbit

import java.io.IOException
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.inputStream

/** The files that a board shows on its drive at [root]. */
internal class DriveFiles(val root: Path) {
    /** Whether it is the drive of a board that takes programs. */
    val isBoard: Boolean get() = has(DETAILS) || has(PAGE)

    /** Why the board has refused the last file; null if it has not. */
    val failure: Failure?
        get() = try {
            val file = root.resolve(FAILURE)
            val text = file.inputStream().use { it.readNBytes(MOST) }.toString(Charsets.ISO_8859_1)
            Failure(ERROR.find(text)?.groupValues?.get(1)?.trim() ?: text.trim(), file.getLastModifiedTime())
        } catch (_: IOException) {
            null
        }

    /** @property words those of the board, in English. */
    data class Failure(val words: String, val written: FileTime)

    private fun has(name: String): Boolean = root.resolve(name).exists()

    private companion object {
        const val DETAILS = "DETAILS.TXT"
        const val PAGE = "MICROBIT.HTM"
        const val FAILURE = "FAIL.TXT"
        val ERROR = Regex("""error: *([^\r\n]+)""")

        /** Bytes; each of these files has some hundred. */
        const val MOST = 10_000
    }
}
