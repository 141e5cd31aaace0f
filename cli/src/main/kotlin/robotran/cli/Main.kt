package robotran.cli

import robotran.console.ExitCode
import robotran.console.ProcessConsole
import robotran.console.tellUncaught
import kotlin.system.exitProcess

/** The command line without the desktop app: no window and no pictures. */
fun main(vararg arguments: String) {
    tellUncaught(arguments.toList())
    val status = CommandLine(ProcessConsole, desktop = null).execute(arguments.toList())
    if (status != ExitCode.DONE.status) exitProcess(status)
}
