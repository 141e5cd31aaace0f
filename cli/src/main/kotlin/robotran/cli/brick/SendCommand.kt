package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo
import robotran.cli.console.Console
import robotran.cli.console.ExitCode
import robotran.cli.console.LanguageOption
import robotran.cli.console.lejosOption
import robotran.cli.console.messages
import robotran.cli.console.speaking
import robotran.cli.image.ImageOfFiles
import robotran.cli.image.buildImage
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tower.LegoLimits

/** `robotran send FILE..`: sends programs to a brick with leJOS. */
internal class SendCommand(private val process: Console, private val towers: () -> Towers) :
    CoreCliktCommand("send") {
    private val files by argument(
        "FILE",
        help = "programs: .robo, .java, .class, .jar or folders of class files; the Prgm button goes through them",
    ).multiple(required = true)
    private val port by portOption()
    private val slot by option("--slot", metavar = "N", help = "1: leJOS has no other program slot")
        .int().restrictTo(1..LegoLimits.SLOTS).default(1)
    private val lejos by lejosOption("the version of leJOS on the brick, ${LejosVersion.DEFAULT.label} if not given")
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) = "Sends programs to a real brick with leJOS, through the infrared tower."

    override fun run() {
        if (slot != 1) {
            console.complain(console.messages.lejosHasNoSlots())
            throw ProgramResult(ExitCode.BAD_INPUT.status)
        }
        val version = lejos ?: LejosVersion.DEFAULT
        val image = when (val built = buildImage(files, spoken.language, version)) {
            is ImageOfFiles.Built -> {
                built.also { it.warnings.forEach(console::complain) }.image
            }

            is ImageOfFiles.Failed -> {
                built.lines.forEach(console::complain)
                throw ProgramResult(built.code.status)
            }
        }
        val code = BrickSession(console, towers()).use(port) { tower ->
            val report = TransferReport.on(console)
            val result = tower.sendProgram(image.bytes, BrickRoom.of(version).maxImageBytes, report::show)
            report.end(result, console.messages::programSent)
        }
        throw ProgramResult(code.status)
    }
}
