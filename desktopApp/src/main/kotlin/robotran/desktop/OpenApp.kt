package robotran.desktop

import robotran.desktop.files.ProgramFiles
import robotran.desktop.files.nameOf
import robotran.desktop.files.readProgramFiles
import robotran.programs.ProgramSource
import robotran.ui.workshop.ProgramFile
import robotran.ui.workshop.PupilProgram

/**
 * Opens the window, with the programs in [files] or, without any, the square, and returns when it is closed.
 *
 * @return what the process is to tell its shell.
 */
internal fun openApp(files: List<String>): ExitCode {
    val sources =
        when (val read = readProgramFiles(files)) {
            is ProgramFiles.Read -> read.programs.map { it.source }
            is ProgramFiles.Refused -> return refuse(read.reason, ExitCode.BAD_INPUT)
        }
    sources.firstOrNull { it is ProgramSource.ClassFiles }?.let { return refuse(COMPILED.replace("NAME", it.name), ExitCode.BAD_INPUT) }
    if (!hasDisplay()) return refuse(NO_DISPLAY, ExitCode.NO_DISPLAY)
    showWindow(sources.mapNotNull(::pupilProgramOf))
    return ExitCode.DONE
}

/** Null for a program without sources, which cannot be written in. */
private fun pupilProgramOf(source: ProgramSource): PupilProgram? =
    when (source) {
        is ProgramSource.Robolang -> PupilProgram(source.name, source.text)
        is ProgramSource.Java -> PupilProgram(source.files.map { ProgramFile(nameOf(it.name), it.text) })
        is ProgramSource.ClassFiles -> null
    }

private fun refuse(message: String, status: ExitCode): ExitCode {
    System.err.println(message)
    return status
}

private const val NO_DISPLAY =
    "There is no display to open a window on. To run a program without one: ./robotran run FILE --picture PICTURE.png"
private const val COMPILED = "NAME is compiled, so there is nothing to show of it. To run it: ./robotran run NAME"
