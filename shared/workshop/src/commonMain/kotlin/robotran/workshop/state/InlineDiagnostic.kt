package robotran.workshop.state

import robotran.brick.program.ProgramFailure
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.languagesupport.TextLines
import robotran.programs.ProgramResult
import robotran.textediting.TextEdit
import robotran.textediting.movedWith

/**
 * A diagnostic at a line of a program.
 *
 * @property isFixStale whether the text that the fix would change has changed since the program was compiled.
 */
data class InlineDiagnostic(val diagnostic: Diagnostic, val kind: NoteKind, val isFixStale: Boolean = false) {
    /** Whether it is only a warning. */
    val isWarning: Boolean get() = kind == NoteKind.DOUBT

    /** The line from 1; null if it has no position. */
    val line: Int? get() = diagnostic.range?.line

    /** Whether [other] is the same diagnostic after a new compilation: at the same line, with the same fix. */
    internal fun hasSameFixAs(other: Diagnostic): Boolean =
        diagnostic.fix != null && diagnostic.fix?.replacement == other.fix?.replacement &&
            diagnostic.file == other.file &&
            line == other.range?.line

    /** This diagnostic after [edit] changed the lines [before] of [file] to [after]; null if its line was deleted. */
    internal fun movedWith(edit: TextEdit, file: String, before: TextLines, after: TextLines): InlineDiagnostic? {
        val range = diagnostic.range
        if (range == null || diagnostic.file != file) return this
        val line = setOf(range.line).movedWith(edit, before).firstOrNull() ?: return null
        val fix = diagnostic.fix
        val movedFix = if (isFixStale) null else fix?.movedWith(edit, before, after)
        val staleFix = fix?.copy(range = fix.range.copy(line = fix.range.line + line - range.line))
        return InlineDiagnostic(
            diagnostic.copy(range = range.copy(line = line), fix = movedFix ?: staleFix),
            kind,
            fix != null && movedFix == null,
        )
    }
}

/** This fix after [edit] changed the lines [before] to [after]; null if the edit overlaps its range. */
private fun SourceFix.movedWith(edit: TextEdit, before: TextLines, after: TextLines): SourceFix? {
    if (range.line > before.count) return null
    val from = before.start(range.line - 1) + range.column - 1
    val to = from + range.endColumn - range.column
    val moved = when {
        edit.start > to -> from
        edit.start + edit.removed.length < from -> from + edit.growth
        else -> return null
    }
    val line = after.lineOf(moved)
    val column = moved - after.start(line) + 1
    return copy(range = SourceRange(line + 1, column, column + to - from, range.file))
}

/** The kind of an inline diagnostic. */
enum class NoteKind {
    /** An error that prevents the program from running. */
    ERROR,

    /** A warning: the program runs, but probably not as intended. */
    DOUBT,

    /** The run failed here. */
    FAILURE,
}

/** The runtime failure of a program in [file] as a diagnostic at its line. */
fun noteOf(failure: ProgramFailure, file: String): InlineDiagnostic {
    val start = SourceRange(failure.sourceLine, 1, 1)
    return InlineDiagnostic(Diagnostic(Severity.ERROR, file, start, failure.message), NoteKind.FAILURE)
}

/** The diagnostics of a compile result, up to a max number, since every keystroke moves them. */
internal fun notesOf(result: ProgramResult): List<InlineDiagnostic> = when (result) {
    is ProgramResult.Success -> result.warnings.take(MAX_NOTES).map { InlineDiagnostic(it, NoteKind.DOUBT) }
    is ProgramResult.Failure -> result.diagnostics.take(MAX_NOTES).map { InlineDiagnostic(it, NoteKind.ERROR) }
}

private const val MAX_NOTES = 300
