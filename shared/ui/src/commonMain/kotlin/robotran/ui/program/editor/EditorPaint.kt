package robotran.ui.program.editor

import androidx.compose.runtime.Immutable
import robotran.robolang.diagnostic.SourceRange
import robotran.textediting.text.Draft
import robotran.textediting.text.TextSpan

/**
 * What is marked in a text. Lines count from 1.
 *
 * @property runningLine the line that is running; 0 for none.
 * @property failedLine the line that a run could not go on at; 0 for none.
 * @property diagnostics the places to underline, and [doubts] those to underline more quietly.
 * @property matches what was found, in its order.
 * @property partners the lines that belong to what somebody looks at on the other side.
 * @property composing what an input method is still working on.
 */
@Immutable
internal data class EditorMarks(
    val runningLine: Int = 0,
    val failedLine: Int = 0,
    val diagnostics: List<SourceRange> = emptyList(),
    val doubts: List<SourceRange> = emptyList(),
    val breakpoints: Set<Int> = emptySet(),
    val matches: List<TextSpan> = emptyList(),
    val partners: Set<Int> = emptySet(),
    val composing: TextSpan? = null,
)

/** All that is drawn of a text. */
@Immutable
internal class EditorPaint(val draft: Draft, val marks: EditorMarks, val hasFocus: Boolean)
