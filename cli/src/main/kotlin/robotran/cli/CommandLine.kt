package robotran.cli

import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import robotran.cli.brick.BrickCommand
import robotran.cli.brick.FirmwareCommand
import robotran.cli.brick.Hubs
import robotran.cli.brick.SendCommand
import robotran.cli.brick.Towers
import robotran.cli.check.CheckCommand
import robotran.cli.console.Console
import robotran.cli.console.DesktopApp
import robotran.cli.console.ExitCode
import robotran.cli.console.languageIn
import robotran.cli.console.tellUnexpected
import robotran.cli.console.visible
import robotran.cli.grade.GradeCommand
import robotran.cli.image.BuildCommand
import robotran.cli.packaging.CourseCommand
import robotran.cli.packaging.PackageCommand
import robotran.cli.run.RunCommand
import robotran.cli.translate.TranslateCommand
import robotran.cli.web.WebCommand

/**
 * The Robotran command line.
 *
 * @param console receives all output.
 * @param desktop opens windows and renders pictures; null if the desktop app is not included.
 * @param towers where the infrared tower is; made by the first command that needs it.
 * @param hubs where hubs with Pybricks are, likewise.
 */
class CommandLine(
    console: Console,
    private val desktop: DesktopApp?,
    private val towers: () -> Towers = Towers::ofThisMachine,
    private val hubs: () -> Hubs = Hubs::ofThisMachine,
) {
    private val console = console.visible()

    /** Runs one command and returns the exit status of the process, see [ExitCode]. */
    fun execute(arguments: List<String>): Int = try {
        carryOut(arguments)
    } catch (problem: Exception) {
        failed(problem, arguments)
    } catch (problem: StackOverflowError) {
        failed(problem, arguments)
    } catch (problem: OutOfMemoryError) {
        failed(problem, arguments)
    }

    private fun failed(problem: Throwable, arguments: List<String>): Int {
        console.tellUnexpected(problem, languageIn(arguments))
        return ExitCode.BROKEN.status
    }

    private fun carryOut(arguments: List<String>): Int {
        val command =
            RobotranCommand(console, desktop).subcommands(
                AppCommand(console, desktop),
                RunCommand(console, desktop),
                GradeCommand(console, desktop),
                CheckCommand(console),
                TranslateCommand(console),
                BuildCommand(console),
                FormatCommand(console),
                RobotCommand(console),
                LinkCommand(console),
                SendCommand(console, towers, hubs),
                FirmwareCommand(console, towers),
                BrickCommand(console, towers),
                WebCommand(console),
                CourseCommand(console),
                PackageCommand(console),
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
