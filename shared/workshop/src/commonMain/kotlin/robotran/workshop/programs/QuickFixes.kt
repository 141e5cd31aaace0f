package robotran.workshop.programs

import robotran.programs.ProgramDiagnostic
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.mendedBy

/**
 * Applies the fixes of mistakes, also those that are wanted before the program was read again: at once where the text
 * that is to be mended is as it was, otherwise as soon as it was read.
 *
 * @param sayGone tells that a fix does not fit the program any more.
 * @param write puts a text in place of that of the file that a robot's programs show.
 */
internal class QuickFixes(private val sayGone: () -> Unit, private val write: (RobotPrograms, String) -> Unit) {
    /** The mistake whose fix waits for the program to be read. */
    private var waiting: ProgramDiagnostic? = null

    val waitsForReading: Boolean get() = waiting != null

    /** The fix of [diagnostic] in the program that [robot] shows is wanted. */
    fun apply(robot: RobotPrograms, diagnostic: ProgramDiagnostic) {
        if (diagnostic.fix == null) return
        val notes = robot.entry.notes
        // It may have been read since the button was drawn.
        val note = notes.firstOrNull { it.diagnostic == diagnostic } ?: notes.firstOrNull { it.mendsAs(diagnostic) }
        when {
            note == null -> sayGone()
            note.isFixStale -> waiting = note.diagnostic
            else -> mend(robot, note)
        }
    }

    /** The programs of [robot] were read, or cannot be: applies the fix that waited for it, if it still fits. */
    fun programsRead(robot: RobotPrograms) {
        val wanted = waiting ?: return
        waiting = null
        val note = if (robot.entry.result == null) null else robot.entry.notes.firstOrNull { it.mendsAs(wanted) }
        if (note == null) sayGone() else mend(robot, note)
    }

    /** What waited is of no use any more. */
    fun forget() {
        waiting = null
    }

    private fun mend(robot: RobotPrograms, note: InlineDiagnostic) {
        val fix = note.diagnostic.fix ?: return
        val file = robot.entry.program.files.indexOfFirst { it.name == note.diagnostic.file }
        if (file < 0) return
        robot.shownFile = file
        robot.shelf.change(robot.shownProgram, robot.entry.without(note))
        write(robot, robot.memory.draft.text.mendedBy(fix))
    }
}
