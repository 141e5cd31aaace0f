package robotran.cli

import com.github.ajalt.clikt.core.subcommands
import robotran.cli.brick.BrickCommand
import robotran.cli.brick.FirmwareCommand
import robotran.cli.brick.Hubs
import robotran.cli.brick.SendCommand
import robotran.cli.brick.Towers
import robotran.cli.check.CheckCommand
import robotran.cli.console.DesktopApp
import robotran.cli.grade.GradeCommand
import robotran.cli.image.BuildCommand
import robotran.cli.packaging.CourseCommand
import robotran.cli.packaging.PackageCommand
import robotran.cli.run.RunCommand
import robotran.cli.translate.TranslateCommand
import robotran.console.Console
import robotran.console.carryOut
import robotran.console.visible
import robotran.desktoptower.microbit.DesktopMicrobitDrives
import robotran.microbitlink.drive.MicrobitDrives
import robotran.siteserver.WebCommand

/**
 * The Robotran command line.
 *
 * @param console receives all output.
 * @param desktop opens windows and renders pictures; null if the desktop app is not included.
 * @param towers where the infrared tower is; made by the first command that needs it.
 * @param hubs where hubs with Pybricks are, likewise.
 * @param drives where the drives of micro:bits are, likewise.
 * @param variable the value of a variable of the environment; null if it is not set.
 */
class CommandLine(
    console: Console,
    private val desktop: DesktopApp?,
    private val towers: () -> Towers = Towers::ofThisMachine,
    private val hubs: () -> Hubs = Hubs::ofThisMachine,
    private val drives: () -> MicrobitDrives = { DesktopMicrobitDrives() },
    private val variable: (String) -> String? = System::getenv,
) {
    private val console = console.visible()

    /** Runs one command and returns the exit status of the process, see [ExitCode]. */
    fun execute(arguments: List<String>): Int = console.carryOut(arguments, variable) {
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
            SendCommand(console, towers, hubs, drives),
            FirmwareCommand(console, towers),
            BrickCommand(console, towers),
            WebCommand(console),
            CourseCommand(console),
            PackageCommand(console),
        )
    }
}
