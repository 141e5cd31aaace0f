package robotran.desktop

import robotran.desktop.cli.CommandLine
import robotran.desktop.cli.ProcessConsole
import java.io.File
import kotlin.system.exitProcess

/** `robotran` and `robotran app` open the window, and so do files alone, as a double click on one gives them; all else is the command line's. */
fun main(vararg arguments: String) {
    val words = arguments.toList()
    val status = CommandLine(ProcessConsole, ::openApp).execute(if (isOpenedFile(words.firstOrNull())) listOf("app") + words else words)
    if (status != ExitCode.DONE.status) exitProcess(status)
}

private fun isOpenedFile(word: String?): Boolean = word != null && ENDINGS.any(word::endsWith) && File(word).isFile

private val ENDINGS = listOf(".robotran", ".world.json", ".robo", ".java")
