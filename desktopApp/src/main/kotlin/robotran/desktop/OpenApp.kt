package robotran.desktop

import java.nio.file.Path
import robotran.ui.workshop.ProgramFile

/**
 * Opens the window, with the program in the first of [files] or, without one, the square, and returns when it is closed.
 *
 * @return the exit status of the process.
 */
internal fun openApp(files: List<String>): Int {
    val program = files.firstOrNull()?.let { name ->
        when (val file = readProgramFile(Path.of(name))) {
            is ProgramFileResult.Read -> file.program
            is ProgramFileResult.Refused -> return refuse(file.message, ExitStatus.BAD_INPUT)
        }
    }
    if (!hasDisplay()) return refuse(NO_DISPLAY, ExitStatus.NO_DISPLAY)
    showWindow(program)
    return ExitStatus.DONE
}

private fun refuse(message: String, status: Int): Int {
    System.err.println(message)
    return status
}

private const val NO_DISPLAY =
    "There is no display to open a window on. To run a program without one: ./robotran run FILE --picture PICTURE.png"
