package robotran.desktop

import robotran.cli.files.noFile
import robotran.console.ExitCode
import robotran.console.ProcessConsole
import robotran.console.visible
import robotran.desktop.platform.openedFile
import robotran.desktop.window.showWindows
import robotran.projects.isLink
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.appLanguage
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Opens the window and returns when it is closed. [files] are programs, worlds, projects or one link; if empty, the
 * last project is opened.
 *
 * @return the exit code of the process.
 */
internal fun openApp(files: List<String>): ExitCode {
    val arrival =
        when (val read = readOpenRequest(files)) {
            is OpenRequestResult.Success -> read.arrival
            is OpenRequestResult.Failure -> return refuse(read.reason, ExitCode.BAD_INPUT)
        }
    if (!hasDisplay()) return refuse(NO_DISPLAY, ExitCode.NO_DISPLAY)
    showWindows(arrival)
    return ExitCode.DONE
}

/** The result of reading the files named on the command line. */
internal sealed interface OpenRequestResult {
    /** [arrival] is null if no file was named. */
    data class Success(val arrival: OpenRequest?) : OpenRequestResult

    data class Failure(val reason: String) : OpenRequestResult
}

/** Reads the files [names]. The shell reports unreadable files; the window reports errors in their content. */
internal fun readOpenRequest(names: List<String>): OpenRequestResult {
    if (names.isEmpty()) return OpenRequestResult.Success(null)
    names.singleOrNull()?.takeIf(::isLink)?.let { return OpenRequestResult.Success(OpenRequest.OfLink(it)) }
    names.firstOrNull {
        it.endsWith(".class") || it.endsWith(".jar")
    }?.let { return OpenRequestResult.Failure(COMPILED.replace("NAME", it)) }
    val opened =
        names.distinct().map { name ->
            val path =
                try {
                    Path.of(name)
                } catch (_: InvalidPathException) {
                    return OpenRequestResult.Failure(noFile(name, appLanguage(null)))
                }
            var error = ""
            openedFile(path) { error = it } ?: return OpenRequestResult.Failure(error)
        }
    return OpenRequestResult.Success(OpenRequest.OfFiles(opened))
}

private fun refuse(message: String, status: ExitCode): ExitCode {
    ProcessConsole.visible().complain(message)
    return status
}

private const val NO_DISPLAY =
    "There is no display to open a window on. To run a program without one: ./robotran run FILE --picture PICTURE.png"
private const val COMPILED = "NAME is compiled, so there is nothing to show of it. To run it: ./robotran run NAME"
