package robotran.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import robotran.cli.console.DesktopApp
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode

/** `robotran` without arguments opens the app. */
internal class RobotranCommand(private val console: Console, private val desktop: DesktopApp?) :
    CoreCliktCommand("robotran") {
    override val invokeWithoutSubcommand = true

    override fun help(context: Context) = "Learn to program a robot: with no command, opens the app."

    override fun helpEpilog(context: Context) =
        "Exit status: 0 if all is well; 1 if the program failed while it ran or, for check, build, send, translate " +
            "and format, has mistakes or is not formatted; 2 if something given cannot be used, " +
            "for run also a program with mistakes; 3 if there is no display; 4 if a real brick could not be reached " +
            "or did not get everything; 70 if Robotran itself has a mistake."

    override fun run() {
        if (currentContext.invokedSubcommand == null) {
            throw ProgramResult(openWindow(console, desktop, emptyList()).status)
        }
    }
}

/** `robotran app FILE..`: opens the app with these programs. */
internal class AppCommand(private val console: Console, private val desktop: DesktopApp?) : CoreCliktCommand("app") {
    private val files by argument(
        "FILE",
        help = "programs, worlds, robots and projects to open (.robo, .java, .world.json, .robot.json, .robotran), " +
            "or a link",
    ).multiple()

    override fun help(context: Context) = "Opens the desktop app."

    override fun run() {
        throw ProgramResult(openWindow(console, desktop, files).status)
    }
}

private fun openWindow(console: Console, desktop: DesktopApp?, files: List<String>): ExitCode {
    if (desktop != null) return desktop.openWindow(files)
    console.complain(console.messages.needsDesktopApp())
    return ExitCode.BAD_INPUT
}
