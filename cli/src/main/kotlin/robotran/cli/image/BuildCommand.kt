package robotran.cli.image

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.console.Console
import robotran.cli.console.ExitCode
import robotran.cli.console.LanguageOption
import robotran.cli.console.lejosOption
import robotran.cli.files.writeFile
import robotran.cli.messages.CommandMessages
import robotran.lejoslinker.LejosImage
import robotran.lejoslinker.listing.listingOf
import robotran.lejoslinker.messages.ImageMessages
import robotran.tinyvm.config.LejosVersion

/** `robotran build FILE..`: makes of programs the image that leJOS's firmware runs. */
internal class BuildCommand(private val console: Console) : CoreCliktCommand("build") {
    private val files by argument(
        "FILE",
        help = "programs: .robo, .java, .class, .jar or folders of class files",
    ).multiple(required = true)
    private val output by option(
        "-o",
        "--output",
        metavar = "FILE",
        help = "where the image goes (.bin); if not given, only its size is told",
    )
    private val listing by option("--listing", help = "prints the image in words").flag()
    private val lejos by lejosOption("the version of leJOS on the brick, ${LejosVersion.DEFAULT.label} if not given")
    private val spoken by LanguageOption()
    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) = "Builds programs for a real brick with leJOS's firmware."

    override fun run() {
        val version = lejos ?: LejosVersion.DEFAULT
        val code = when (val built = buildImage(files, spoken.language, version)) {
            is ImageOfFiles.Built -> {
                built.warnings.forEach(console::say)
                write(built.image, version)
            }

            is ImageOfFiles.Failed -> {
                built.lines.forEach(console::complain)
                built.code
            }
        }
        throw ProgramResult(code.status)
    }

    private fun write(image: LejosImage, version: LejosVersion): ExitCode {
        output?.let { name -> writeFile(name, image.bytes, sentences)?.let { return refuse(it) } }
        if (listing) console.say(listingOf(image, ImageMessages.of(spoken.language).listing).trimEnd('\n'))
        val left = image.bytesForObjects(version)
        console.say(sentences.imageBuilt(output, image.bytes.size.toString(), left.toString()))
        return ExitCode.DONE
    }

    private fun refuse(reason: String): ExitCode {
        console.complain(reason)
        return ExitCode.BAD_INPUT
    }
}
