package robotran.workshop.run

import kotlinx.coroutines.launch
import robotran.rcxrom.log.toLogText
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Saving
import robotran.workshop.service.Bench
import robotran.workshop.state.LogState
import robotran.workshop.state.Notice

/** Takes the ROM calls that are shown out of the app. */
internal class RomLogExport(private val bench: Bench) {
    /** Copies them as text. */
    fun copy(log: LogState) {
        val text = log.entries.toLogText()
        bench.scope.launch {
            val isDone = bench.platform.sharing.copy(text)
            bench.say(if (isDone) Notice.LogCopied else Notice.LogNotCopied)
        }
    }

    /** Saves them as a text file named after the [program]. */
    fun save(log: LogState, program: String) {
        val bytes = log.entries.toLogText().encodeToByteArray()
        bench.scope.launch {
            val saving = bench.platform.files.save("$program${FileKind.TEXT.extension}", FileKind.TEXT, bytes)
            if (saving is Saving.Failed) bench.say(Notice.ForeignError(saving.reason))
        }
    }
}
