package robotran.workshop.run

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import robotran.brick.log.toLogText
import robotran.legofirmware.device.DatalogEntry
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.Notices
import robotran.workshop.state.LogState
import robotran.workshop.state.Notice

/** Exports the visible ROM calls, and the datalog. */
internal class RomLogExport(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val notices: Notices,
) {
    /** Copies them as text. */
    fun copy(log: LogState) {
        val text = log.entries.toLogText()
        scope.launch {
            val isDone = platform.sharing.copy(text)
            notices.show(if (isDone) Notice.LogCopied else Notice.LogNotCopied)
        }
    }

    /** Saves them to a text file named after [program]. */
    fun save(log: LogState, program: String) = save(program, FileKind.TEXT, log.entries.toLogText())

    /** Saves the datalog as a table named after [program]. */
    fun save(datalog: List<DatalogEntry>, variables: Map<Int, String>, program: String) =
        save("$program datalog", FileKind.CSV, datalog.toCsv(variables))

    private fun save(name: String, kind: FileKind, text: String) {
        scope.launch {
            val saving = platform.files.save("$name${kind.extension}", kind, text.encodeToByteArray())
            if (saving is Saving.Failed) notices.show(Notice.ExternalError(saving.reason))
        }
    }
}
