package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.subcommands
import robotran.console.Console

/** `robotran brick`: commands about a real brick. */
internal class BrickCommand(console: Console, towers: () -> Towers) : CoreCliktCommand("brick") {
    init {
        subcommands(
            BrickStatusCommand(console, towers),
            BrickDatalogCommand(console, towers),
            BrickClockCommand(console, towers),
            BrickEmptyCommand(console, towers),
        )
    }

    override fun help(context: Context) = "Asks a real brick, or tells it something, through the infrared tower."

    override fun run() = Unit
}
