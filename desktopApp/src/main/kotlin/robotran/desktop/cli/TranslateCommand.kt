package robotran.desktop.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.option
import robotran.desktop.ExitCode
import robotran.desktop.files.writeFile
import robotran.desktop.messages.CommandMessages
import robotran.robolang.translate.kitFiles
import robotran.robolang.translate.translateRobolang
import kotlin.io.path.Path
import kotlin.io.path.name

/** `robotran translate FILE..`: writes programs as Java for leJOS, or one as a kit with all that a real brick takes. */
internal class TranslateCommand(
    private val console: Console,
) : CoreCliktCommand("translate") {
    private val programs by argument("FILE", help = "Robolang programs (.robo)").multiple(required = true)
    private val output by option("-o", "--output", metavar = "FILE", help = "where the Java goes; to the console if not given")
    private val kit by option("--kit", metavar = "FILE", help = "writes a kit for the real brick (.zip)")

    private val spoken by LanguageOption()
    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) = "Writes programs as leJOS Java for a real robot."

    override fun run() {
        if (programs.size > 1 && (output != null || kit != null)) throw UsageError("-o and --kit take one program at a time")
        throw ProgramResult(programs.maxOf { translate(it).status })
    }

    private fun translate(program: String): ExitCode =
        when (val file = readRobolangFile(program, spoken.language)) {
            is RobolangFile.Ready -> {
                write(program, file)
            }

            is RobolangFile.Mistaken -> {
                file.diagnostics.forEach { console.complain(lineOf(program, it)) }
                ExitCode.PROGRAM_FAILED
            }

            is RobolangFile.Unreadable -> {
                console.complain(file.reason)
                ExitCode.BAD_INPUT
            }
        }

    private fun write(
        program: String,
        file: RobolangFile.Ready,
    ): ExitCode {
        val translation = translateRobolang(file.program)
        val problems =
            listOfNotNull(
                output?.let { writeFile(it, translation.java.encodeToByteArray(), sentences) },
                kit?.let { writeFile(it, zip(kitFiles(translation, Path(program).name, file.source)), sentences) },
            )
        problems.forEach(console::complain)
        if (output == null && kit == null) console.say(translation.java.trimEnd('\n'))
        return if (problems.isEmpty()) ExitCode.DONE else ExitCode.BAD_INPUT
    }
}
