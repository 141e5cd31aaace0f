package robotran.workshop.programs

import robotran.language.source.Diagnostic
import robotran.programs.withFix
import robotran.workshop.state.InlineDiagnostic

/** Applies quick fixes. If the text has changed since it was compiled, a fix waits for the next compilation. */
internal class QuickFixes {
    /** The diagnostic whose fix waits for the compiler. */
    private var waiting: Diagnostic? = null

    val waitsForCompiler: Boolean get() = waiting != null

    /** Applies the fix of [diagnostic] in the current program of [robot]. */
    fun apply(robot: RobotPrograms, diagnostic: Diagnostic): QuickFixResult {
        if (diagnostic.fix == null) return QuickFixResult.Nothing
        val notes = robot.entry.notes
        // The program may have been compiled since the button was drawn.
        val note =
            notes.firstOrNull { it.diagnostic == diagnostic } ?: notes.firstOrNull { it.hasSameFixAs(diagnostic) }
        if (note?.isFixStale == true) {
            waiting = note.diagnostic
            return QuickFixResult.Nothing
        }
        return if (note == null) QuickFixResult.Outdated else fix(robot, note)
    }

    /** Called when the programs of [robot] were compiled or compilation failed. Applies a waiting fix. */
    fun programsCompiled(robot: RobotPrograms): QuickFixResult {
        val diagnostic = waiting ?: return QuickFixResult.Nothing
        waiting = null
        val notes = if (robot.entry.result == null) emptyList() else robot.entry.notes
        val note = notes.firstOrNull { it.hasSameFixAs(diagnostic) } ?: return QuickFixResult.Outdated
        return fix(robot, note)
    }

    /** Drops the waiting fix. */
    fun cancel() {
        waiting = null
    }

    /** Shows the file of [note] and drops the note. */
    private fun fix(robot: RobotPrograms, note: InlineDiagnostic): QuickFixResult {
        val fix = note.diagnostic.fix ?: return QuickFixResult.Nothing
        val file = robot.entry.program.files.indexOfFirst { it.name == note.diagnostic.file }
        if (file < 0) return QuickFixResult.Nothing
        robot.shownFile = file
        robot.list.change(robot.shownProgram, robot.entry.without(note))
        return QuickFixResult.NewText(robot.editorState.draft.text.withFix(fix))
    }
}

/** What a quick fix does to the shown file. */
internal sealed interface QuickFixResult {
    /** The file gets [text]. */
    data class NewText(val text: String) : QuickFixResult

    /** The fix no longer applies. */
    data object Outdated : QuickFixResult

    /** The fix waits for the compiler, or there is none. */
    data object Nothing : QuickFixResult
}
