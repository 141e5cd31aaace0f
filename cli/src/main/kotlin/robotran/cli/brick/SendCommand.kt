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
import robotran.cli.console.oldNqcOption
import robotran.cli.console.speaking
import robotran.cli.console.targetOption
import robotran.cli.files.FIRMWARE_ENDINGS
import robotran.cli.image.ImageOfFiles
import robotran.cli.image.buildImage
import robotran.cli.legofirmware.FirmwareImageOfFile
import robotran.cli.legofirmware.firmwareImageOf
import robotran.legofirmware.image.RcxImage
import robotran.programs.FirmwareSettings
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tower.LegoLimits
import robotran.tower.rcx.RcxTower

/** `robotran send FILE..`: sends programs to a brick with the firmware of leJOS or LEGO. */
internal class SendCommand(private val process: Console, private val towers: () -> Towers) :
    CoreCliktCommand("send") {
    private val files by argument(
        "FILE",
        help =
            "programs for leJOS: .robo, .java, .class, .jar or folders of class files; or for LEGO's firmware: .nqc, " +
                ".lasm, .rcx; the Prgm button goes through them",
    ).multiple(required = true)
    private val port by portOption()
    private val slot by option(
        "--slot",
        metavar = "N",
        help = "the slot of LEGO's firmware for the first program, 1 to 5; leJOS has no slots",
    )
        .int().restrictTo(1..LegoLimits.SLOTS).default(1)
    private val lejos by lejosOption("the version of leJOS on the brick, ${LejosVersion.DEFAULT.label} if not given")
    private val target by targetOption()
    private val oldNqc by oldNqcOption()
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) =
        "Sends programs to a real brick with leJOS or LEGO's firmware, through the infrared tower."

    override fun run() {
        if (files.all { name -> FIRMWARE_ENDINGS.any(name::endsWith) }) throw ProgramResult(sendToSlots().status)
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

    /** Sends programs into slots of LEGO's firmware. */
    private fun sendToSlots(): ExitCode {
        val programs = files.distinct()
        if (slot + programs.size - 1 > LegoLimits.SLOTS) {
            console.complain(console.messages.tooFewSlots(LegoLimits.SLOTS))
            return ExitCode.BAD_INPUT
        }
        val images = programs.map { name ->
            when (val built = firmwareImageOf(name, FirmwareSettings(target, oldNqc), spoken.language)) {
                is FirmwareImageOfFile.Built -> {
                    built.also { it.warnings.forEach(console::complain) }.image
                }

                is FirmwareImageOfFile.Failed -> {
                    built.lines.forEach(console::complain)
                    return built.code
                }
            }
        }
        return BrickSession(console, towers()).use(port) { tower -> send(images, tower) }
    }

    private suspend fun send(images: List<RcxImage>, tower: RcxTower): ExitCode {
        images.forEachIndexed { index, image ->
            val report = TransferReport.on(console)
            val result = tower.sendLegoProgram(slot + index, image.toLegoProgram(), report::show)
            val code = report.end(result) { bytes -> console.messages.programInSlot(slot + index, bytes) }
            if (code != ExitCode.DONE) return code
        }
        return ExitCode.DONE
    }
}
