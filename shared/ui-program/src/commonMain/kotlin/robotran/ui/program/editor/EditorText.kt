package robotran.ui.program.editor

import androidx.compose.runtime.Immutable
import robotran.language.source.Diagnostic
import robotran.languagesupport.TextLines
import robotran.textediting.text.TextDocument
import robotran.workshop.state.InlineDiagnostic

/**
 * What an editor shows.
 *
 * @property hint the placeholder for empty text.
 * @property notes the diagnostics at the lines, in order.
 * @property isErrorPointedOut whether to highlight the first error.
 */
@Immutable
internal class EditorText(
    val draft: TextDocument,
    val hint: String,
    val marks: EditorMarks,
    val notes: List<InlineDiagnostic>,
    val isErrorPointedOut: Boolean,
)

/** What the user does in an editor that needs more than its text. */
internal interface EditorActions {
    fun perform(command: EditorCommand.Plain)

    /** Toggles the breakpoint of [line], from 1. */
    fun toggleBreakpoint(line: Int)

    /** Scales the font size by [factor]; small steps accumulate. */
    fun zoom(factor: Float)

    fun fix(diagnostic: Diagnostic)
}

/** The text of the line that the fix of [note] would change. */
internal fun TextLines.lineOfFix(note: InlineDiagnostic): String {
    val line = note.diagnostic.fix?.range?.line ?: return ""
    return if (line in 1..count) line(line - 1) else ""
}
