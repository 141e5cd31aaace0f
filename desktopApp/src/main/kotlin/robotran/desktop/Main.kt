package robotran.desktop

import robotran.desktop.cli.CommandLine
import robotran.desktop.cli.ProcessConsole
import kotlin.system.exitProcess

/** `robotran` and `robotran app [FILE]` open the window; everything else is the command line's. */
fun main(vararg arguments: String) {
    val status = CommandLine(ProcessConsole, ::openApp).execute(arguments.toList())
    if (status != ExitCode.DONE.status) exitProcess(status)
}
