package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.optional
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.tower.TowerResult
import robotran.tower.rcx.RcxTower
import java.time.LocalTime
import java.time.format.DateTimeFormatter
import java.time.format.DateTimeParseException

/** `robotran brick clock`: sets the clock of LEGO's own firmware. */
internal class BrickClockCommand(console: Console, towers: () -> Towers) : BrickSubcommand("clock", console, towers) {
    private val time by argument(
        "TIME",
        help = "hours and minutes, such as 13:37; the time of this machine if not given",
    )
        .optional()
    private val moment by lazy { read(time) }

    override fun help(context: Context) = "Sets the clock of a real brick with LEGO's own firmware."

    override fun run() {
        moment
        super.run()
    }

    override suspend fun use(tower: RcxTower): ExitCode =
        when (val set = tower.setLegoClock(moment.hour, moment.minute)) {
            is TowerResult.Success -> ExitCode.DONE.also {
                console.say(console.messages.clockSet(WORDS.format(moment)))
            }

            is TowerResult.Failure -> failed(set)
        }

    private fun read(text: String?): LocalTime = try {
        text?.let { LocalTime.parse(it, GIVEN) } ?: LocalTime.now()
    } catch (_: DateTimeParseException) {
        refuse(console.messages.notATime(text.orEmpty()))
    }

    private companion object {
        val GIVEN: DateTimeFormatter = DateTimeFormatter.ofPattern("H:mm")
        val WORDS: DateTimeFormatter = DateTimeFormatter.ofPattern("HH:mm")
    }
}
