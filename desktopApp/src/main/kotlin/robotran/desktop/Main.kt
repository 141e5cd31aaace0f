package robotran.desktop

import robotran.cli.CommandLine
import robotran.cli.console.DesktopApp
import robotran.console.ExitCode
import robotran.console.ProcessConsole
import robotran.console.tellUncaught
import robotran.language.ProgramLanguage
import robotran.simulation.picture.WorldPictures
import robotran.ui.pictures.DrawnWorldPictures
import java.io.File
import kotlin.system.exitProcess

/**
 * `robotran`, `robotran app` and plain file names, as from a double click, open the window. The command line handles
 * all else.
 */
fun main(vararg arguments: String) {
    val words = arguments.toList()
    tellUncaught(words)
    val status = CommandLine(ProcessConsole, ComposeApp).execute(
        if (isOpenedFile(words.firstOrNull())) {
            listOf("app") +
                words
        } else {
            words
        },
    )
    if (status != ExitCode.DONE.status) exitProcess(status)
}

/** The window and the pictures of this app. */
internal object ComposeApp : DesktopApp {
    override val pictures: WorldPictures by lazy { DrawnWorldPictures() }

    override fun openWindow(files: List<String>): ExitCode = openApp(files)
}

private fun isOpenedFile(word: String?): Boolean = word != null && ENDINGS.any(word::endsWith) && File(word).isFile

private val ENDINGS =
    listOf(".robotran", ".world.json", ".robot.json", ".course.json", ".rcx") +
        ProgramLanguage.entries.map { it.extension }
