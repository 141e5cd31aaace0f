package robotran.cli

import robotran.cli.console.ExitCode
import robotran.cli.console.ProcessConsole
import robotran.cli.console.tellUncaught
import kotlin.system.exitProcess

/** The command line without the desktop app: no window and no pictures. */
fun main(vararg arguments: String) {
    tellUncaught(arguments.toList())
    val status = CommandLine(ProcessConsole, desktop = null).execute(arguments.toList())
    if (status != ExitCode.DONE.status) exitProcess(status)
}
