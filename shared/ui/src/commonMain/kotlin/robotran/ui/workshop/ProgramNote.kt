package robotran.ui.workshop

import robotran.editing.TextEdit
import robotran.editing.TextLines
import robotran.editing.movedWith
import robotran.programs.Mistake
import robotran.programs.ProgramResult
import robotran.robolang.SourceRange
import robotran.rom.ProgramFailure

/** What is told about a line of a program. */
data class ProgramNote(val mistake: Mistake, val kind: NoteKind) {
    /** Whether the program can run all the same. */
    val isDoubt: Boolean get() = kind == NoteKind.DOUBT

    /** The line it is about, from 1; null if it is at no place. */
    val line: Int? get() = mistake.range?.line

    /** The same once [edit] has changed the file called [file]; null if its line has gone. */
    internal fun movedWith(edit: TextEdit, file: String, before: TextLines): ProgramNote? {
        val range = mistake.range
        if (range == null || mistake.file != file) return this
        val line = setOf(range.line).movedWith(edit, before).firstOrNull() ?: return null
        return if (line == range.line) this else copy(mistake = mistake.copy(range = range.copy(line = line)))
    }
}

/** Why a line of a program has a note. */
enum class NoteKind {
    /** Nothing runs before this is mended. */
    MISTAKE,

    /** It runs, but hardly as it is meant. */
    DOUBT,

    /** The run could not go on here. */
    FAILURE,
}

/** What has come of a run in [file], told at its line. */
internal fun noteOf(failure: ProgramFailure, file: String): ProgramNote {
    val start = SourceRange(failure.sourceLine, 1, 1)
    return ProgramNote(Mistake(file, start, failure.message), NoteKind.FAILURE)
}

/** What reading a program has brought to tell, the first of it if that is very much: every key moves it. */
internal fun notesOf(result: ProgramResult): List<ProgramNote> = when (result) {
    is ProgramResult.Ready -> result.warnings.take(MOST_NOTES).map { ProgramNote(it, NoteKind.DOUBT) }
    is ProgramResult.Mistaken -> result.mistakes.take(MOST_NOTES).map { ProgramNote(it, NoteKind.MISTAKE) }
}

private const val MOST_NOTES = 300
