package robotran.cli.brick

import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import robotran.tower.TowerResult
import robotran.tower.rcx.RcxTower

/** A command of `robotran brick`. */
internal abstract class BrickSubcommand(name: String, private val process: Console, private val towers: () -> Towers) :
    CoreCliktCommand(name) {
    private val port by portOption()
    private val spoken by LanguageOption()
    protected val console get() = process.speaking(spoken.language)

    /** Does the command's work with the tower. */
    protected abstract suspend fun use(tower: RcxTower): ExitCode

    override fun run() {
        throw ProgramResult(BrickSession(console, towers()).use(port, ::use).status)
    }

    protected fun failed(result: TowerResult.Failure): ExitCode {
        console.complain(console.messages.sentence(result.error))
        return ExitCode.NO_BRICK
    }

    /** Ends the command before the tower is looked for. */
    protected fun refuse(reason: String): Nothing {
        console.complain(reason)
        throw ProgramResult(ExitCode.BAD_INPUT.status)
    }
}
