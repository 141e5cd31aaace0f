package robotran.desktop.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import robotran.desktop.ExitCode

/** `robotran check FILE..`: tells all mistakes of all files. */
internal class CheckCommand(
    private val console: Console,
) : CoreCliktCommand("check") {
    private val files by argument("FILE", help = "Robolang programs (.robo)").multiple(required = true)
    private val asJson by option("--json", help = "tells the mistakes as JSON").flag()

    override fun help(context: Context) = "Tells all mistakes of programs, without running them."

    override fun run() {
        val results = files.map { it to readRobolangFile(it) }
        if (asJson) console.say(diagnosticsJson(results)) else results.forEach { (name, file) -> tell(name, file) }
        throw ProgramResult(results.maxOf { statusOf(it.second).status })
    }

    private fun tell(
        name: String,
        file: RobolangFile,
    ) {
        when (file) {
            is RobolangFile.Ready -> {
                file.warnings.forEach { console.say("${lineOf(name, it)} (a warning)") }
                console.say("$name has no mistakes.")
            }

            is RobolangFile.Mistaken -> {
                file.diagnostics.forEach { console.complain(lineOf(name, it)) }
            }

            is RobolangFile.Unreadable -> {
                console.complain(file.reason)
            }
        }
    }

    private fun statusOf(file: RobolangFile): ExitCode =
        when (file) {
            is RobolangFile.Ready -> ExitCode.DONE
            is RobolangFile.Mistaken -> ExitCode.PROGRAM_FAILED
            is RobolangFile.Unreadable -> ExitCode.BAD_INPUT
        }
}
