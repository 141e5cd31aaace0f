package robotran.cli.brick

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.console.messages
import robotran.cli.files.writeFile
import robotran.console.Console
import robotran.console.ExitCode
import robotran.legofirmware.device.csvOf
import robotran.tower.TowerResult
import robotran.tower.rcx.RcxTower

/** `robotran brick datalog`: reads the datalog of LEGO's own firmware. */
internal class BrickDatalogCommand(console: Console, towers: () -> Towers) :
    BrickSubcommand("datalog", console, towers) {
    private val output by option(
        "-o",
        "--output",
        metavar = "FILE",
        help = "where the entries go, as CSV; if not given, they are printed",
    )

    override fun help(context: Context) =
        "Reads the datalog of a real brick with LEGO's own firmware. The brick keeps it."

    override suspend fun use(tower: RcxTower): ExitCode {
        val report = TransferReport.on(console)
        val datalog = tower.readLegoDatalog(report::showEntries).also { report.clear() }
        return when (datalog) {
            is TowerResult.Failure -> failed(datalog)

            is TowerResult.Success -> when {
                datalog.value.isEmpty() -> ExitCode.DONE.also { console.mention("${console.messages.noDatalog()}\n") }
                else -> write(csvOf(datalog.value), datalog.value.size)
            }
        }
    }

    private fun write(csv: String, entries: Int): ExitCode {
        val name = output ?: return ExitCode.DONE.also { console.say(csv.trimEnd('\n')) }
        writeFile(name, csv.encodeToByteArray(), console.messages)?.let { reason ->
            console.complain(reason)
            return ExitCode.BAD_INPUT
        }
        console.say(console.messages.datalogWritten(name, entries))
        return ExitCode.DONE
    }
}
