package robotran.ui.program.blocks

import androidx.compose.runtime.Immutable
import robotran.language.source.SourceSpan
import robotran.textediting.text.TextDocument

/**
 * The lines, from 1, in which the search has found something.
 *
 * @property now the line of the match that is selected; 0 for none.
 */
@Immutable
internal data class FoundLines(val all: Set<Int> = emptySet(), val now: Int = 0) {
    companion object {
        fun of(draft: TextDocument, matches: List<SourceSpan>): FoundLines {
            if (matches.isEmpty()) return FoundLines()
            val selected = draft.selection
            val now = matches.firstOrNull { it.start == selected.start && it.end == selected.end }
            return FoundLines(
                matches.mapTo(mutableSetOf()) { draft.lines.lineOf(it.start) + 1 },
                now?.let { draft.lines.lineOf(it.start) + 1 } ?: 0,
            )
        }
    }
}
