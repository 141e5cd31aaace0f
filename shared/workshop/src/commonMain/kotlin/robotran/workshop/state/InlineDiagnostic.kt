package robotran.workshop.state

import robotran.programs.ProgramDiagnostic
import robotran.programs.ProgramResult
import robotran.rcxrom.program.ProgramFailure
import robotran.robolang.diagnostic.SourceFix
import robotran.robolang.diagnostic.SourceRange
import robotran.textediting.TextEdit
import robotran.textediting.movedWith
import robotran.textediting.text.TextLines

/**
 * What is told about a line of a program.
 *
 * @property isFixStale whether the text that the mistake's fix would change is another since the program was read.
 */
data class InlineDiagnostic(val diagnostic: ProgramDiagnostic, val kind: NoteKind, val isFixStale: Boolean = false) {
    /** Whether the program can run all the same. */
    val isDoubt: Boolean get() = kind == NoteKind.DOUBT

    /** The line it is about, from 1; null if it is at no place. */
    val line: Int? get() = diagnostic.range?.line

    /**
     * Whether this is [other] as it may be told once the program was read again: at the same line, with the same fix.
     */
    internal fun mendsAs(other: ProgramDiagnostic): Boolean =
        diagnostic.fix != null && diagnostic.fix?.replacement == other.fix?.replacement &&
            diagnostic.file == other.file &&
            line == other.range?.line

    /**
     * The same once [edit] has made the lines [after] of [before] in the file called [file]; null if its line has gone.
     */
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

/**
 * Where this fix belongs once [edit] has made the lines [after] of [before]; null if the edit has touched what it would
 * change.
 */
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
    return copy(range = SourceRange(line + 1, column, column + to - from))
}

/** Why a line of a program has a note. */
enum class NoteKind {
    /** Nothing runs before this is mended. */
    ERROR,

    /** It runs, but hardly as it is meant. */
    DOUBT,

    /** The run could not go on here. */
    FAILURE,
}

/** What has come of a run in [file], told at its line. */
fun noteOf(failure: ProgramFailure, file: String): InlineDiagnostic {
    val start = SourceRange(failure.sourceLine, 1, 1)
    return InlineDiagnostic(ProgramDiagnostic(file, start, failure.message), NoteKind.FAILURE)
}

/** What reading a program has brought to tell, the first of it if that is very much: every key moves it. */
internal fun notesOf(result: ProgramResult): List<InlineDiagnostic> = when (result) {
    is ProgramResult.Ready -> result.warnings.take(MAX_NOTES).map { InlineDiagnostic(it, NoteKind.DOUBT) }
    is ProgramResult.HasErrors -> result.diagnostics.take(MAX_NOTES).map { InlineDiagnostic(it, NoteKind.ERROR) }
}

private const val MAX_NOTES = 300
