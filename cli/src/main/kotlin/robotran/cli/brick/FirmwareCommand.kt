package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import robotran.cli.console.messages
import robotran.cli.files.FileContent
import robotran.cli.files.readContent
import robotran.cli.files.reading
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.readFirmwareFile
import java.nio.file.Path

/** `robotran firmware FILE`: sends a firmware to a brick. */
internal class FirmwareCommand(private val process: Console, private val towers: () -> Towers) :
    CoreCliktCommand("firmware") {
    private val file by argument("FILE", help = "a firmware: lejos.srec of leJOS, or firm0328.lgo of LEGO")
    private val port by portOption()
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) = "Sends a firmware to a real brick, in place of the one that it has."

    override fun run() {
        val firmware = read()
        console.mention("${console.messages.sentence(firmware, file)}\n")
        val code = BrickSession(console, towers()).use(port) { tower ->
            val report = TransferReport.on(console)
            report.end(tower.sendFirmware(firmware, report::show), console.messages::firmwareSent)
        }
        throw ProgramResult(code.status)
    }

    private fun read(): FirmwareImage {
        val content = reading(file, console.messages, FileContent::Failure) {
            readContent(Path.of(file), file, LARGEST_FIRMWARE_FILE, console.messages)
        }
        return when (content) {
            is FileContent.Failure -> refuse(content.reason)

            is FileContent.Success -> when (val result = readFirmwareFile(content.bytes)) {
                is FirmwareFile.Success -> result.firmware
                is FirmwareFile.Failure -> refuse(console.messages.sentence(result.reason, file))
            }
        }
    }

    private fun refuse(reason: String): Nothing {
        console.complain(reason)
        throw ProgramResult(ExitCode.BAD_INPUT.status)
    }

    private companion object {
        /** In bytes. A firmware of 32 KB in hex digits has 100,000. */
        const val LARGEST_FIRMWARE_FILE = 1_000_000
    }
}
