package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo
import robotran.brick.kind.BrickKind
import robotran.cli.console.brickOption
import robotran.cli.console.buggyOption
import robotran.cli.console.lejosOption
import robotran.cli.console.messages
import robotran.cli.console.oldNqcOption
import robotran.cli.console.targetOption
import robotran.cli.files.FileContent
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.isNamed
import robotran.cli.files.readFile
import robotran.cli.files.readProgramFiles
import robotran.cli.hub.HubProgramOfFile
import robotran.cli.hub.hubOf
import robotran.cli.hub.hubProgramOf
import robotran.cli.hub.pythonOf
import robotran.cli.hub.requireImages
import robotran.cli.image.ImageOfFiles
import robotran.cli.image.buildImageOf
import robotran.cli.legofirmware.FirmwareImageOfFile
import robotran.cli.legofirmware.firmwareImageOf
import robotran.cli.microbit.HexOfFile
import robotran.cli.microbit.boardOf
import robotran.cli.microbit.hexOf
import robotran.cli.microbit.microPythonOption
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import robotran.hublink.program.HubProgram
import robotran.legofirmware.image.RcxImage
import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.drive.MicrobitDrives
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.sentences.sentence
import robotran.programs.FirmwareSettings
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tower.LegoLimits
import robotran.tower.rcx.RcxTower
import java.nio.file.Path

/** `robotran send FILE..`: sends programs to a brick with leJOS, or into slots of one with LEGO's own firmware. */
internal class SendCommand(
    private val process: Console,
    private val towers: () -> Towers,
    private val hubs: () -> Hubs,
    private val drives: () -> MicrobitDrives,
) : CoreCliktCommand("send") {
    private val files by argument(
        "FILE",
        help = "programs: .robo, .java, .class, .jar or folders of class files, which the Prgm button goes through; " +
            "or for LEGO's own firmware: .nqc, .lasm or .rcx, each into a slot; or for a hub with Pybricks: " +
            "one .mpy, or one .robo that names it or with --brick; or for a micro:bit: one .hex, or one .robo that " +
            "names it or with --brick",
    ).multiple(required = true)
    private val port by portOption()
    private val slot by option(
        "--slot",
        metavar = "N",
        help = "the slot of LEGO's own firmware, 1 (if not given) to ${LegoLimits.SLOTS}; of the first program, " +
            "if there are several. leJOS has no slots",
    ).int().restrictTo(1..LegoLimits.SLOTS).default(1)
    private val lejos by lejosOption("the version of leJOS on the brick, ${LejosVersion.DEFAULT.label} if not given")
    private val target by targetOption()
    private val oldNqc by oldNqcOption()
    private val brick by brickOption()
    private val buggy by buggyOption()
    private val microPython by microPythonOption()
    private val drive by option(
        "--drive",
        metavar = "FOLDER",
        help = "where the drive MICROBIT of the board is; if not given, it is looked for",
    )
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) =
        "Sends programs to a real brick with the firmware of leJOS or LEGO, through the infrared tower, to a hub " +
            "with Pybricks, by USB, or onto the drive of a micro:bit."

    override fun run() {
        val board = boardOf(files, brick, buggy, spoken.language)
        val isForMicrobit = board != null || files.any { isNamed(it, HEX) }
        requireFitting(isForMicrobit)
        if (isForMicrobit) throw ProgramResult(sendToMicrobit(board).status)
        val hub = hubOf(files, brick, spoken.language)
        if (hub != null || files.any { it.endsWith(HUB_PROGRAM) }) throw ProgramResult(sendToHub(hub).status)
        brick?.let(::requireImages)
        val programs = when (val read = readProgramFiles(files, console.messages)) {
            is ProgramFiles.Success -> read.programs.also { read.notes.forEach(console::complain) }
            is ProgramFiles.Failure -> refuse(read.reason)
        }
        val forLego = programs.count { it.source.isForLegoFirmware }
        val code = when (forLego) {
            0 -> sendToLejos(programs)
            programs.size -> sendToLego(programs)
            else -> refuse(console.messages.twoFirmwares())
        }
        throw ProgramResult(code.status)
    }

    /** No option may be left out silently. */
    private fun requireFitting(isForMicrobit: Boolean) {
        if (!isForMicrobit && (drive != null || microPython != null)) {
            throw UsageError("--drive and --micropython go with a micro:bit")
        }
        if (isForMicrobit && (port != AUTO || slot != 1)) {
            throw UsageError("--port and --slot do not go with a micro:bit")
        }
    }

    private fun sendToHub(hub: BrickKind?): ExitCode {
        val name = files.singleOrNull() ?: refuse(console.messages.oneProgramForHub())
        if (slot != 1) refuse(console.messages.hubChoosesSlot())
        val program = hub?.takeUnless { name.endsWith(HUB_PROGRAM) }?.let { compiled(name, it) } ?: compiledBefore(name)
        return HubSession(console, hubs()).send(program, port)
    }

    private fun compiled(name: String, hub: BrickKind): HubProgram =
        when (val built = hubProgramOf(name, hub, spoken.language)) {
            is HubProgramOfFile.Success -> built.program.also { built.warnings.forEach(console::complain) }
            is HubProgramOfFile.Failure -> refuse(built.lines, built.code)
        }

    private fun compiledBefore(name: String): HubProgram {
        val bytes = when (val read = readFile(Path.of(name), spoken.language)) {
            is FileContent.Success -> read.bytes
            is FileContent.Failure -> refuse(read.reason)
        }
        return HubProgram.read(bytes) ?: refuse(console.messages.noHubProgram(name))
    }

    private fun sendToMicrobit(board: BrickKind?): ExitCode {
        val name = files.singleOrNull() ?: refuse(console.messages.oneProgramForMicrobit())
        val hex = board?.takeUnless { isNamed(name, HEX) }?.let { built(name, it) } ?: builtBefore(name)
        return MicrobitDriveSession(console, drives()).copy(hex, drive)
    }

    private fun built(name: String, board: BrickKind): ByteArray {
        val python = pythonOf(name, board, spoken.language, buggy)
        return when (val built = hexOf(python, board, microPython, spoken.language)) {
            is HexOfFile.Success -> built.text.encodeToByteArray().also { built.warnings.forEach(console::complain) }
            is HexOfFile.Failure -> refuse(built.lines, built.code)
        }
    }

    /** A file that was built before, or any other for a micro:bit. */
    private fun builtBefore(name: String): ByteArray {
        val bytes = when (val read = readFile(Path.of(name), spoken.language)) {
            is FileContent.Success -> read.bytes
            is FileContent.Failure -> refuse(read.reason)
        }
        val mistake = (MicroPythonFile.read(bytes.decodeToString()) as? ImageResult.Failure)?.error
        // A program of another editor is none of our business.
        if (mistake != null &&
            mistake != ImageError.NoMicroPython
        ) {
            refuse("$name: ${mistake.sentence(spoken.language)}")
        }
        return bytes
    }

    private fun sendToLejos(programs: List<NamedProgram>): ExitCode {
        if (slot != 1) refuse(console.messages.lejosHasNoSlots())
        val version = lejos ?: LejosVersion.DEFAULT
        val image = when (val built = buildImageOf(programs, spoken.language, version)) {
            is ImageOfFiles.Success -> built.also { it.warnings.forEach(console::complain) }.image
            is ImageOfFiles.Failure -> refuse(built.lines, built.code)
        }
        return BrickSession(console, towers()).use(port) { tower ->
            val report = TransferReport.on(console)
            val result = tower.sendProgram(image.bytes, BrickRoom.of(version).maxImageBytes, report::show)
            report.end(result) { console.messages.programSent(it) }
        }
    }

    private fun sendToLego(programs: List<NamedProgram>): ExitCode {
        if (slot + programs.size - 1 > LegoLimits.SLOTS) {
            refuse(console.messages.tooFewSlots(slot, programs.size, LegoLimits.SLOTS))
        }
        // All are compiled before the first is sent.
        val images = programs.map { program ->
            when (val built = firmwareImageOf(program, FirmwareSettings(target, oldNqc), spoken.language)) {
                is FirmwareImageOfFile.Success -> built.also { it.warnings.forEach(console::complain) }.image
                is FirmwareImageOfFile.Failure -> refuse(built.lines, built.code)
            }
        }
        return BrickSession(console, towers()).use(port) { tower -> send(images, tower) }
    }

    private suspend fun send(images: List<RcxImage>, tower: RcxTower): ExitCode {
        images.forEachIndexed { index, image ->
            val place = slot + index
            val report = TransferReport.on(console, place)
            val result = tower.sendLegoProgram(place, image, report::show)
            val code = report.end(result) { console.messages.programInSlot(it, place) }
            if (code != ExitCode.DONE) return code
        }
        return ExitCode.DONE
    }

    private fun refuse(reason: String): Nothing = refuse(listOf(reason), ExitCode.BAD_INPUT)

    private fun refuse(lines: List<String>, code: ExitCode): Nothing {
        lines.forEach(console::complain)
        throw ProgramResult(code.status)
    }

    private companion object {
        /** The ending of a compiled program for a hub. */
        const val HUB_PROGRAM = ".mpy"

        /** The ending of a file for a micro:bit. */
        const val HEX = ".hex"
    }
}
