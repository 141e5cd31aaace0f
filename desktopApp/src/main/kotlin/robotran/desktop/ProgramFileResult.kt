package robotran.desktop

import robotran.robolang.RobolangLimits
import robotran.ui.workshop.ProgramFile
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/** What came of reading a program from a file. */
internal sealed interface ProgramFileResult {
    data class Read(val program: ProgramFile) : ProgramFileResult

    /** It cannot be read; [message] is one sentence that says why. */
    data class Refused(val message: String) : ProgramFileResult
}

/** Reads the program in [file], never more of it than a program can have. */
internal fun readProgramFile(file: Path): ProgramFileResult {
    if (!file.isRegularFile()) return ProgramFileResult.Refused("There is no file `$file`.")
    return try {
        val bytes = Files.newInputStream(file).use { it.readNBytes(MOST_BYTES + 1) }
        if (bytes.size > MOST_BYTES) {
            ProgramFileResult.Refused("`$file` is too long to be a program.")
        } else {
            ProgramFileResult.Read(ProgramFile(file.name, bytes.decodeToString()))
        }
    } catch (_: IOException) {
        ProgramFileResult.Refused("`$file` cannot be read.")
    }
}

/** A character of UTF-8 has at most three bytes for each UTF-16 character. */
private const val MOST_BYTES = 3 * RobolangLimits.SOURCE_CHARACTERS
