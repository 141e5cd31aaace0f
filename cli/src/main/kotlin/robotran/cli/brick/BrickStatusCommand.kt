package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.tower.BrickStatus
import robotran.tower.TowerResult
import robotran.tower.rcx.RcxTower

/** `robotran brick status`: tells what the brick is. */
internal class BrickStatusCommand(console: Console, towers: () -> Towers) : BrickSubcommand("status", console, towers) {
    override fun help(context: Context) = "Tells the firmware of a real brick. It keeps its program."

    override suspend fun use(tower: RcxTower): ExitCode = when (val status = tower.status()) {
        is TowerResult.Success -> ExitCode.DONE.also { sentences(status.value).forEach(console::say) }
        is TowerResult.Failure -> failed(status)
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
