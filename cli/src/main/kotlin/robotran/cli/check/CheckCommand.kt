package robotran.cli.check

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.console.brickOption
import robotran.cli.console.oldNqcOption
import robotran.cli.console.targetOption
import robotran.cli.input.RobolangFile
import robotran.cli.input.lineOf
import robotran.cli.messages.CommandMessages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.programs.FirmwareSettings
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET

/** `robotran check FILE..`: prints all diagnostics of all files. */
internal class CheckCommand(private val console: Console) : CoreCliktCommand("check") {
    private val files by argument(
        "FILE",
        help =
            "programs in Robolang (.robo), NQC (.nqc) or assembly text (.lasm), the files of a Java program (.java), " +
                "or compiled ones (.class, .jar, .rcx); also worlds (.world.json), robots (.robot.json), projects " +
                "and assignments (.robotran) and courses (.course.json or its folder)",
    )
        .multiple(required = true)
    private val brick by brickOption()
    private val options by JavaOptions()
    private val target by targetOption()
    private val oldNqc by oldNqcOption()
    private val spoken by LanguageOption()
    private val asJson by option("--json", help = "tells the mistakes as JSON").flag()

    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) =
        "Tells all mistakes of programs, worlds, robots, assignments and courses, without running them."

    override fun run() {
        val compiler =
            ProgramCompiler(PENBOT_TARGET, options.java, spoken.language, FirmwareSettings(target, oldNqc))
        val results = checkFiles(files, compiler, brick, isForBrick = options.version != null)
        if (asJson) console.say(diagnosticsJson(results)) else results.forEach { (name, file) -> tell(name, file) }
        throw ProgramResult(results.maxOf { statusOf(it.second).status })
    }

    private fun tell(name: String, file: CheckedFile) {
        file.notes.forEach { console.say(sentences.warning(it)) }
        when (file) {
            is CheckedFile.Robolang -> tell(name, file)

            is CheckedFile.Java -> tell(
                name,
                file.diagnostics.map { lineOf(if (file.isCompiled) "$name: ${it.file}" else name, it) },
                file.warnings.map { lineOf(name, it) },
            )

            is CheckedFile.Firmware -> tell(
                name,
                file.diagnostics.map { lineOf(file.program, it) },
                file.warnings.map { lineOf(file.program, it) },
            )

            is CheckedFile.Described -> tell(
                name,
                listOfNotNull(file.error).map { "$name: ${it.message}" },
                file.warnings.map { "$name: ${it.message}" },
            )

            is CheckedFile.Unreadable -> console.complain(file.reason)
        }
    }

    private fun tell(name: String, checked: CheckedFile.Robolang) {
        when (val file = checked.file) {
            is RobolangFile.Ready -> {
                val (errors, notes) = checked.translated.partition { checked.isForBrick }
                val refused = notes.map { it.copy(message = sentences.refusedByBrick(it.message)) }
                tell(
                    name,
                    errors.map { lineOf(name, it) },
                    file.warnings.map { lineOf(name, it) } + refused.map { lineOf(name, it) },
                )
            }

            is RobolangFile.HasErrors -> tell(name, file.diagnostics.map { lineOf(name, it) }, emptyList())
            is RobolangFile.Unreadable -> console.complain(file.reason)
        }
    }

    private fun tell(name: String, diagnostics: List<String>, warnings: List<String>) {
        diagnostics.forEach(console::complain)
        warnings.forEach { console.say(sentences.warning(it)) }
        if (diagnostics.isEmpty()) console.say(sentences.noMistakes(name))
    }

    private fun statusOf(file: CheckedFile): ExitCode = when (file) {
        is CheckedFile.Robolang -> if (file.canRun) ExitCode.DONE else ExitCode.PROGRAM_FAILED
        is CheckedFile.Java -> if (file.diagnostics.isEmpty()) ExitCode.DONE else ExitCode.PROGRAM_FAILED
        is CheckedFile.Firmware -> if (file.diagnostics.isEmpty()) ExitCode.DONE else ExitCode.PROGRAM_FAILED
        is CheckedFile.Described -> if (file.error == null) ExitCode.DONE else ExitCode.PROGRAM_FAILED
        is CheckedFile.Unreadable -> ExitCode.BAD_INPUT
    }
}
