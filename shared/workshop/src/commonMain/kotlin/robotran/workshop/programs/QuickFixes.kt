package robotran.workshop.programs

import robotran.programs.ProgramDiagnostic
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.withFix

/**
 * Applies quick fixes. If the text has changed since it was compiled, a fix waits for the next compilation.
 *
 * @param sayGone reports that a fix no longer applies.
 * @param write replaces the text of the file that a robot's programs show.
 */
internal class QuickFixes(private val sayGone: () -> Unit, private val write: (RobotPrograms, String) -> Unit) {
    /** The diagnostic whose fix waits for the compiler. */
    private var waiting: ProgramDiagnostic? = null

    val waitsForReading: Boolean get() = waiting != null

    /** Applies the fix of [diagnostic] in the current program of [robot]. */
    fun apply(robot: RobotPrograms, diagnostic: ProgramDiagnostic) {
        if (diagnostic.fix == null) return
        val notes = robot.entry.notes
        // The program may have been compiled since the button was drawn.
        val note =
            notes.firstOrNull { it.diagnostic == diagnostic } ?: notes.firstOrNull { it.hasSameFixAs(diagnostic) }
        when {
            note == null -> sayGone()
            note.isFixStale -> waiting = note.diagnostic
            else -> mend(robot, note)
        }
    }

    /** Called when the programs of [robot] were compiled or compilation failed. Applies a waiting fix. */
    fun programsRead(robot: RobotPrograms) {
        val wanted = waiting ?: return
        waiting = null
        val note = if (robot.entry.result == null) null else robot.entry.notes.firstOrNull { it.hasSameFixAs(wanted) }
        if (note == null) sayGone() else mend(robot, note)
    }

    /** Drops the waiting fix. */
    fun forget() {
        waiting = null
    }

    private fun mend(robot: RobotPrograms, note: InlineDiagnostic) {
        val fix = note.diagnostic.fix ?: return
        val file = robot.entry.program.files.indexOfFirst { it.name == note.diagnostic.file }
        if (file < 0) return
        robot.shownFile = file
        robot.shelf.change(robot.shownProgram, robot.entry.without(note))
        write(robot, robot.memory.draft.text.withFix(fix))
    }
}
