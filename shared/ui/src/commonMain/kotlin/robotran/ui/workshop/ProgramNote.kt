package robotran.ui.workshop

import robotran.editing.TextEdit
import robotran.editing.TextLines
import robotran.editing.movedWith
import robotran.programs.Mistake
import robotran.programs.ProgramResult

/**
 * What is told about a line of a program.
 *
 * @property isDoubt whether the program can run all the same.
 */
data class ProgramNote(val mistake: Mistake, val isDoubt: Boolean) {
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

/** What reading a program has brought to tell. */
internal fun notesOf(result: ProgramResult): List<ProgramNote> = when (result) {
    is ProgramResult.Ready -> result.warnings.map { ProgramNote(it, isDoubt = true) }
    is ProgramResult.Mistaken -> result.mistakes.map { ProgramNote(it, isDoubt = false) }
}
