package robotran.siteserver

import com.github.ajalt.clikt.core.CoreNoOpCliktCommand
import com.github.ajalt.clikt.core.subcommands
import robotran.console.ExitCode
import robotran.console.ProcessConsole
import robotran.console.carryOut
import robotran.console.tellUncaught
import robotran.console.visible
import kotlin.system.exitProcess

/** The command `web` alone, without all that the other commands need. */
fun main(vararg arguments: String) {
    tellUncaught(arguments.toList())
    val console = ProcessConsole.visible()
    val status = console.carryOut(arguments.toList()) {
        CoreNoOpCliktCommand("robotran").subcommands(WebCommand(console))
    }
    if (status != ExitCode.DONE.status) exitProcess(status)
}
