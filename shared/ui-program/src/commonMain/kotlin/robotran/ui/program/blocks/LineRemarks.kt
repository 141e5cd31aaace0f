package robotran.ui.program.blocks

import androidx.compose.runtime.Immutable
import robotran.workshop.blocks.BlockRow
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.NoteKind

/**
 * What there is to say about the lines of a program.
 *
 * @property runningLine the line that runs, from 1; 0 for none.
 * @param notes the diagnostics at the lines.
 * @property found the lines with matches of the search.
 */
@Immutable
internal class LineRemarks(
    private val breakpoints: Set<Int>,
    private val runningLine: Int,
    notes: List<InlineDiagnostic>,
    val found: FoundLines,
) {
    private val notesByLine = notes.groupBy { it.line ?: 0 }
    private val failedLine = notes.firstOrNull { it.kind == NoteKind.FAILURE }?.line ?: 0

    /** The line that runs or has failed, from 1; 0 for none. */
    val litLine: Int get() = if (runningLine > 0) runningLine else failedLine

    fun marksOf(row: BlockRow, isCarried: Boolean): RowMarks {
        val line = row.line?.let { it.index + 1 } ?: return RowMarks(isCarried = isCarried)
        // A collapsed block tells what there is to know about the lines that it hides.
        val lines = if (row is BlockRow.First && row.isCollapsed) line..row.block.lines.last + 1 else line..line
        return RowMarks(
            line in breakpoints,
            runningLine in lines,
            lines.flatMap { notesByLine[it].orEmpty() },
            isCarried,
            lines.any { it in found.all },
            found.now in lines,
        )
    }
}
