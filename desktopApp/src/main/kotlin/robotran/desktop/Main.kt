package robotran.desktop

import kotlin.system.exitProcess

/** `robotran` and `robotran app [FILE]` open the window; everything else is the command line's. */
fun main(vararg arguments: String) {
    val status = if (arguments.isEmpty() || arguments.first() == "app") openApp(arguments.drop(1)) else refuse(arguments.first())
    if (status != ExitStatus.DONE) exitProcess(status)
}

private fun refuse(command: String): Int {
    System.err.println("`$command` is not a command. Use: robotran app FILE")
    return ExitStatus.BAD_INPUT
}
