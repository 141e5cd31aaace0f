package robotran.cli.image

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import robotran.brick.kind.BrickKind
import robotran.cli.console.brickOption
import robotran.cli.console.buggyOption
import robotran.cli.console.lejosOption
import robotran.cli.console.oldNqcOption
import robotran.cli.console.targetOption
import robotran.cli.files.FIRMWARE_ENDINGS
import robotran.cli.files.RCX_IMAGE
import robotran.cli.files.ROBOLANG
import robotran.cli.files.isNamed
import robotran.cli.files.mayWrite
import robotran.cli.files.writeFile
import robotran.cli.hub.HubProgramOfFile
import robotran.cli.hub.hubOf
import robotran.cli.hub.hubProgramOf
import robotran.cli.hub.pythonOf
import robotran.cli.hub.requireImages
import robotran.cli.legofirmware.FirmwareImageOfFile
import robotran.cli.legofirmware.firmwareImageOf
import robotran.cli.messages.CommandMessages
import robotran.cli.microbit.HexOfFile
import robotran.cli.microbit.boardOf
import robotran.cli.microbit.hexOf
import robotran.cli.microbit.microPythonOption
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.toBytes
import robotran.legofirmware.listing.plainListing
import robotran.lejoslinker.LejosImage
import robotran.lejoslinker.listing.listingOf
import robotran.lejoslinker.messages.ListingMessages
import robotran.programs.FirmwareSettings
import robotran.tinyvm.config.LejosVersion

/** `robotran build FILE..`: makes of programs the image that leJOS's firmware runs, or of one that of LEGO's own. */
internal class BuildCommand(private val console: Console) : CoreCliktCommand("build") {
    private val files by argument(
        "FILE",
        help =
            "programs: .robo, .java, .class, .jar or folders of class files; or one for LEGO's own firmware: .nqc, " +
                ".lasm or .rcx",
    ).multiple(required = true)
    private val output by option(
        "-o",
        "--output",
        metavar = "FILE",
        help = "where the image goes (.bin, for LEGO's own firmware .rcx, for a hub .mpy, for a micro:bit .hex); if not " +
            "given, only its size is told",
    )
    private val listing by option("--listing", help = "prints the image in words, for a hub or micro:bit the Python")
        .flag()
    private val lejos by lejosOption("the version of leJOS on the brick, ${LejosVersion.DEFAULT.label} if not given")
    private val target by targetOption()
    private val oldNqc by oldNqcOption()
    private val brick by brickOption()
    private val buggy by buggyOption()
    private val microPython by microPythonOption()
    private val spoken by LanguageOption()
    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) =
        "Builds programs for a real brick with the firmware of leJOS or LEGO, or one for a hub with Pybricks or " +
            "for a micro:bit."

    override fun run() {
        if (!mayWrite(files, listOf(output), console.speaking(spoken.language))) {
            throw ProgramResult(ExitCode.BAD_INPUT.status)
        }
        boardOf(files, brick, buggy, spoken.language)?.let { throw ProgramResult(buildHex(it).status) }
        hubOf(files, brick, spoken.language)?.let { throw ProgramResult(build(it).status) }
        brick?.let(::requireImages)
        throw ProgramResult((files.distinct().singleOrNull()?.takeIf(::isForFirmware)?.let(::build) ?: build()).status)
    }

    /** A program in Robolang is for whichever firmware the name of the image tells. */
    private fun isForFirmware(name: String): Boolean = FIRMWARE_ENDINGS.any { isNamed(name, it) } ||
        (isNamed(name, ROBOLANG) && output?.endsWith(RCX_IMAGE) == true)

    /** For leJOS. */
    private fun build(): ExitCode {
        val version = lejos ?: LejosVersion.DEFAULT
        return when (val built = buildImage(files, spoken.language, version)) {
            is ImageOfFiles.Success -> {
                built.warnings.forEach(console::say)
                write(built.image, version)
            }

            is ImageOfFiles.Failure -> {
                built.lines.forEach(console::complain)
                built.code
            }
        }
    }

    /** For LEGO's own firmware. */
    private fun build(program: String): ExitCode =
        when (val built = firmwareImageOf(program, FirmwareSettings(target, oldNqc), spoken.language)) {
            is FirmwareImageOfFile.Success -> {
                built.warnings.forEach(console::say)
                write(built.image)
            }

            is FirmwareImageOfFile.Failure -> {
                built.lines.forEach(console::complain)
                built.code
            }
        }

    /** For a hub with Pybricks. */
    private fun build(hub: BrickKind): ExitCode {
        val name = files.distinct().singleOrNull() ?: return refuse(sentences.oneProgramForHub())
        return when (val built = hubProgramOf(name, hub, spoken.language)) {
            is HubProgramOfFile.Success -> {
                built.warnings.forEach(console::say)
                write(built)
            }

            is HubProgramOfFile.Failure -> {
                built.lines.forEach(console::complain)
                built.code
            }
        }
    }

    /** For a micro:bit. */
    private fun buildHex(board: BrickKind): ExitCode {
        val name = files.distinct().singleOrNull() ?: return refuse(sentences.oneProgramForMicrobit())
        val python = pythonOf(name, board, spoken.language, buggy)
        return when (val built = hexOf(python, board, microPython, spoken.language)) {
            is HexOfFile.Success -> {
                built.warnings.forEach(console::say)
                write(built)
            }

            is HexOfFile.Failure -> {
                built.lines.forEach(console::complain)
                built.code
            }
        }
    }

    private fun write(built: HexOfFile.Success): ExitCode {
        output?.let { name -> writeFile(name, built.text.encodeToByteArray(), sentences)?.let { return refuse(it) } }
        if (listing) console.say(built.python.trimEnd('\n'))
        console.say(sentences.hexBuilt(output, built.bytes, built.maxBytes))
        return ExitCode.DONE
    }

    private fun write(built: HubProgramOfFile.Success): ExitCode {
        val bytes = built.program.bytes
        output?.let { name -> writeFile(name, bytes, sentences)?.let { return refuse(it) } }
        if (listing) console.say(built.python.trimEnd('\n'))
        console.say(sentences.hubProgramBuilt(output, bytes.size.toString()))
        return ExitCode.DONE
    }

    private fun write(image: LejosImage, version: LejosVersion): ExitCode {
        output?.let { name -> writeFile(name, image.bytes, sentences)?.let { return refuse(it) } }
        if (listing) console.say(listingOf(image, ListingMessages.of(spoken.language)).trimEnd('\n'))
        val left = image.bytesForObjects(version)
        console.say(sentences.imageBuilt(output, image.bytes.size.toString(), left.toString()))
        return ExitCode.DONE
    }

    private fun write(image: RcxImage): ExitCode {
        output?.let { name -> writeFile(name, image.toBytes(), sentences)?.let { return refuse(it) } }
        if (listing) console.say(image.plainListing().trimEnd('\n'))
        val limit = FirmwareLimits.PROGRAM_MEMORY
        console.say(sentences.firmwareImageBuilt(output, image.codeSize.toString(), limit.toString()))
        return ExitCode.DONE
    }

    private fun refuse(reason: String): ExitCode {
        console.complain(reason)
        return ExitCode.BAD_INPUT
    }
}
