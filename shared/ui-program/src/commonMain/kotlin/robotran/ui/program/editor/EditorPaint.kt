package robotran.ui.program.editor

import androidx.compose.runtime.Immutable
import robotran.language.source.SourceRange
import robotran.language.source.SourceSpan
import robotran.textediting.text.TextDocument

/**
 * The markings of a text. Lines start at 1.
 *
 * @property runningLine the running line; 0 for none.
 * @property failedLine the line where a run failed; 0 for none.
 * @property diagnostics the ranges to underline; [warnings] are underlined less prominently.
 * @property matches the search results, in order.
 * @property partners the lines that correspond to the caret's line in the other text.
 * @property runningPartners the lines that correspond to the running line of the other text.
 * @property composing the range that an input method is composing.
 */
@Immutable
internal data class EditorMarks(
    val runningLine: Int = 0,
    val failedLine: Int = 0,
    val diagnostics: List<SourceRange> = emptyList(),
    val warnings: List<SourceRange> = emptyList(),
    val breakpoints: Set<Int> = emptySet(),
    val matches: List<SourceSpan> = emptyList(),
    val partners: Set<Int> = emptySet(),
    val runningPartners: Set<Int> = emptySet(),
    val composing: SourceSpan? = null,
)

/** Everything to draw of a text. */
@Immutable
internal class EditorPaint(val draft: TextDocument, val marks: EditorMarks, val hasFocus: Boolean)
