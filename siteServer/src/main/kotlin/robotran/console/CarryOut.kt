package robotran.console

import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.core.parse

/**
 * Lets what [command] returns carry out [arguments]; the exit status of the process, see [ExitCode].
 *
 * @param variable the value of a variable of the environment; null if it is not set.
 */
fun Console.carryOut(
    arguments: List<String>,
    variable: (String) -> String? = System::getenv,
    command: () -> CoreCliktCommand,
): Int = try {
    parse(arguments, command().context { readEnvvar = variable })
} catch (problem: Exception) {
    failed(problem, arguments)
} catch (problem: StackOverflowError) {
    failed(problem, arguments)
} catch (problem: OutOfMemoryError) {
    failed(problem, arguments)
}

private fun Console.failed(problem: Throwable, arguments: List<String>): Int {
    tellUnexpected(problem, languageIn(arguments))
    return ExitCode.BROKEN.status
}

private fun Console.parse(arguments: List<String>, command: CoreCliktCommand): Int = try {
    command.parse(arguments)
    ExitCode.DONE.status
} catch (result: ProgramResult) {
    result.statusCode
} catch (error: CliktError) {
    val words = command.getFormattedHelp(error).orEmpty()
    if (error.statusCode == 0) say(words) else complain(words)
    if (error.statusCode == 0) ExitCode.DONE.status else ExitCode.BAD_INPUT.status
}
