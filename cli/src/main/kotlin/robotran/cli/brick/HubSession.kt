package robotran.cli.brick

import kotlinx.coroutines.runBlocking
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.hublink.HubDescription
import robotran.hublink.HubError
import robotran.hublink.HubResult
import robotran.hublink.connection.OpenedHub
import robotran.hublink.hub.HubLink
import robotran.hublink.program.HubProgram
import robotran.hublink.sentences.sentence

/** Sends programs to the hub that the user means. */
internal class HubSession(private val console: Console, private val hubs: Hubs) {
    /** Sends [program] to the hub at [port]; complains if there is none. The program does not start. */
    fun send(program: HubProgram, port: String): ExitCode = runBlocking {
        val device = if (port == AUTO) hubs.ports.available().firstOrNull() else hubs.named(port)
        if (device == null) return@runBlocking failed(console.messages.noHub())
        when (val opened = hubs.ports.open(device)) {
            is OpenedHub.Failure -> failed(opened.error)

            is OpenedHub.Success -> {
                val link = HubLink(opened.connection, scope = this)
                try {
                    send(program, link, device.id)
                } finally {
                    link.close()
                }
            }
        }
    }

    private suspend fun send(program: HubProgram, link: HubLink, port: String): ExitCode =
        when (val opened = link.open()) {
            is HubResult.Failure -> failed(opened.error)

            is HubResult.Success -> {
                console.mention("${words(opened.value, port)}\n")
                val report = TransferReport.on(console)
                report.end(link.send(program, report::show))
            }
        }

    private fun words(hub: HubDescription, port: String) =
        console.messages.hubAt(port, hub.kind.productName, hub.firmware.toString())

    private fun failed(error: HubError) = failed(error.sentence(console.language))

    private fun failed(words: String): ExitCode {
        console.complain(words)
        return ExitCode.NO_BRICK
    }
}
