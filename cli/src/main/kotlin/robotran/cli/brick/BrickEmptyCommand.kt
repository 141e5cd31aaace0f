package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.tower.LegoLimits
import robotran.tower.TowerResult
import robotran.tower.rcx.RcxTower

/** `robotran brick empty SLOT..`: deletes programs of LEGO's own firmware, which share one memory. */
internal class BrickEmptyCommand(console: Console, towers: () -> Towers) : BrickSubcommand("empty", console, towers) {
    private val slots by argument("SLOT", help = "slots, 1 to ${LegoLimits.SLOTS}")
        .int().restrictTo(1..LegoLimits.SLOTS).multiple(required = true)

    override fun help(context: Context) = "Deletes the programs in slots of a real brick with LEGO's own firmware."

    override suspend fun use(tower: RcxTower): ExitCode {
        for (slot in slots.distinct()) {
            when (val deleted = tower.deleteLegoProgram(slot)) {
                is TowerResult.Success -> console.say(console.messages.slotEmptied(slot))
                is TowerResult.Failure -> return failed(deleted)
            }
        }
        return ExitCode.DONE
    }
}
