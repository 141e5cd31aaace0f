package robotran.desktoptower.microbit

import robotran.microbitlink.MicrobitBoard
import java.io.IOException
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText

/** The files that a board shows on its drive at [root]. */
internal class DriveFiles(val root: Path) {
    /** Whether it is the drive of a board that takes programs. */
    val isBoard: Boolean get() = has(DETAILS) || has(PAGE)

    /** Which board it is; null if it does not tell. */
    val board: MicrobitBoard?
        get() = read(DETAILS)?.let(UNIQUE_ID::find)?.let { MicrobitBoard.ofId(it.groupValues[1].toInt(HEXADECIMAL)) }

    /** Why the board has refused the last file, in its own words; null if it has not. */
    val refusal: String?
        get() = read(FAILURE)?.let { text -> ERROR.find(text)?.groupValues?.get(1)?.trim() ?: text.trim() }

    private fun has(name: String): Boolean = try {
        root.resolve(name).exists()
    } catch (_: InvalidPathException) {
        false
    }

    private fun read(name: String): String? = try {
        root.resolve(name).readText(Charsets.ISO_8859_1).take(MOST)
    } catch (_: IOException) {
        null
    }

    private companion object {
        const val DETAILS = "DETAILS.TXT"
        const val PAGE = "MICROBIT.HTM"
        const val FAILURE = "FAIL.TXT"
        val UNIQUE_ID = Regex("""Unique ID: *([0-9a-fA-F]{4})""")
        val ERROR = Regex("""error: *([^\r\n]+)""")
        const val HEXADECIMAL = 16

        /** Characters; each of these files has some hundred. */
        const val MOST = 10_000
    }
}
