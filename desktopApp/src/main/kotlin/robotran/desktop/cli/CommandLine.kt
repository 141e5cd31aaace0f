package robotran.desktop.cli

import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import robotran.desktop.ExitCode
import robotran.desktop.cli.grade.GradeCommand
import robotran.language.Language

/**
 * The command line of Robotran.
 *
 * @param console where its words go.
 * @param openWindow opens the desktop app on these files and returns once it is closed.
 */
class CommandLine(
    private val console: Console,
    private val openWindow: (files: List<String>) -> ExitCode,
) {
    /** Carries out one command; the answer is the process's exit status, see [ExitCode]. */
    fun execute(arguments: List<String>): Int {
        val command =
            RobotranCommand(openWindow).subcommands(
                AppCommand(openWindow),
                RunCommand(console),
                GradeCommand(console),
                CheckCommand(console),
                TranslateCommand(console),
                FormatCommand(console),
                LinkCommand(console),
                WebCommand(console, WebCommand::waitForEver),
            )
        return try {
            command.parse(arguments)
            ExitCode.DONE.status
        } catch (result: ProgramResult) {
            result.statusCode
        } catch (error: CliktError) {
            val words = command.getFormattedHelp(error).orEmpty()
            if (error.statusCode == 0) console.say(words) else console.complain(words)
            if (error.statusCode == 0) ExitCode.DONE.status else ExitCode.BAD_INPUT.status
        }
    }
}

/** Where the command line's words go; tests give one that remembers them. */
interface Console {
    /** What is spoken at it. */
    val language: Language get() = Language.ENGLISH

    /** Says what was asked for. */
    fun say(words: String)

    /** Says what is wrong. */
    fun complain(words: String)

    /** Says how far some work is, just as it stands, with no end of line. */
    fun mention(words: String)
}

/** The console of the process: standard output and standard error. */
object ProcessConsole : Console {
    override fun say(words: String) = println(words)

    override fun complain(words: String) = System.err.println(words)

    override fun mention(words: String) {
        System.err.print(words)
        System.err.flush()
    }
}
