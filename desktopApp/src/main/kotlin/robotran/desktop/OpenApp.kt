package robotran.desktop

import robotran.ui.workshop.ProgramFile
import kotlin.io.path.name
import java.nio.file.Path

/**
 * Opens the window, with the program in the first of [files] or, without one, the square, and returns when it is closed.
 *
 * @return what the process is to tell its shell.
 */
internal fun openApp(files: List<String>): ExitCode {
    val program = files.firstOrNull()?.let { name ->
        when (val file = readTextFile(name)) {
            is TextFile.Read -> ProgramFile(Path.of(name).name, file.text)
            is TextFile.Refused -> return refuse(file.reason, ExitCode.BAD_INPUT)
        }
    }
    if (!hasDisplay()) return refuse(NO_DISPLAY, ExitCode.NO_DISPLAY)
    showWindow(program)
    return ExitCode.DONE
}

private fun refuse(message: String, status: ExitCode): ExitCode {
    System.err.println(message)
    return status
}

private const val NO_DISPLAY =
    "There is no display to open a window on. To run a program without one: ./robotran run FILE --picture PICTURE.png"
