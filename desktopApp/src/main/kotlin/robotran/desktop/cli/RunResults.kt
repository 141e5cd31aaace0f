package robotran.desktop.cli

import robotran.ui.sheet.sheetPicture
import robotran.world.Session

/** Writes what a finished run is to leave behind. */
internal class RunResults(
    private val session: Session,
    private val console: Console,
) {
    /** Writes all that [outputs] ask for and says in a sentence how the run ended; the answer is what could not be written. */
    fun write(outputs: RunOutputs): List<String> {
        val report = session.report()
        val problems =
            listOfNotNull(
                outputs.picture?.let { writeFile(it, sheetPicture(session.world, session.state, PICTURE_WIDTH)) },
                outputs.romLog?.let { writeText(it, session.romLog.entries.joinToString("") { entry -> entry.text + "\n" }) },
                outputs.report?.let { writeText(it, report.toJson() + "\n") },
            )
        report.error?.let { console.complain(it) }
        if (CONSOLE !in listOf(outputs.romLog, outputs.report)) console.say(report.summary())
        return problems
    }

    private fun writeText(
        name: String,
        text: String,
    ): String? =
        if (name == CONSOLE) {
            console.say(text.trimEnd('\n'))
            null
        } else {
            writeFile(name, text.encodeToByteArray())
        }

    private companion object {
        const val CONSOLE = "-"

        /** Pixels: fine enough to measure in, small enough to mail. */
        const val PICTURE_WIDTH = 1200
    }
}
