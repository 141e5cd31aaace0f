package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.subcommands
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import robotran.cli.console.Console
import robotran.cli.console.ExitCode
import robotran.cli.console.LanguageOption
import robotran.cli.console.messages
import robotran.cli.console.speaking
import robotran.tower.BrickStatus
import robotran.tower.TowerResult

/** `robotran brick`: commands about a real brick. */
internal class BrickCommand(console: Console, towers: () -> Towers) : CoreCliktCommand("brick") {
    init {
        subcommands(BrickStatusCommand(console, towers))
    }

    override fun help(context: Context) = "Asks a real brick through the infrared tower."

    override fun run() = Unit
}

/** `robotran brick status`: tells what the brick is. */
internal class BrickStatusCommand(private val process: Console, private val towers: () -> Towers) :
    CoreCliktCommand("status") {
    private val port by portOption()
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) = "Tells the firmware of a real brick. It keeps its program."

    override fun run() {
        val code = BrickSession(console, towers()).use(port) { tower ->
            when (val status = tower.status()) {
                is TowerResult.Success -> ExitCode.DONE.also { sentences(status.value).forEach(console::say) }

                is TowerResult.Failed -> ExitCode.NO_BRICK.also {
                    console.complain(console.messages.sentence(status.error))
                }
            }
        }
        throw ProgramResult(code.status)
    }

    private fun sentences(status: BrickStatus): List<String> = when (status) {
        is BrickStatus.LejosOrNoFirmware -> listOf(console.messages.brickHasLejosOrNothing("${status.rom}"))

        is BrickStatus.LegoFirmware -> listOfNotNull(
            console.messages.brickHasLego("${status.firmware}", "${status.rom}"),
            status.millivolts?.let { console.messages.batteryIs(volts(it)) },
        )

        BrickStatus.Unknown -> listOf(console.messages.brickIsUnknown())
    }
}
