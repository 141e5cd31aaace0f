package robotran.ui.workshop

import kotlinx.coroutines.launch
import robotran.rcxrom.log.toLogText
import robotran.ui.platform.FileKind
import robotran.ui.platform.Saving
import robotran.ui.resources.Res
import robotran.ui.resources.run_log_copied
import robotran.ui.resources.run_log_not_copied

/** Takes the ROM calls that are shown out of the app. */
internal class RomLogExport(private val bench: Bench) {
    /** Copies them as text. */
    fun copy(log: LogState) {
        val text = log.entries.toLogText()
        bench.scope.launch {
            val isDone = bench.platform.sharing.copy(text)
            bench.say(Notice(if (isDone) Res.string.run_log_copied else Res.string.run_log_not_copied, bad = !isDone))
        }
    }

    /** Saves them as a text file named after the [program]. */
    fun save(log: LogState, program: String) {
        val bytes = log.entries.toLogText().encodeToByteArray()
        bench.scope.launch {
            val saving = bench.platform.files.save("$program${FileKind.TEXT.extension}", FileKind.TEXT, bytes)
            if (saving is Saving.Failed) bench.say(Notice(null, plain = saving.reason, bad = true))
        }
    }
}
