package robotran.ui.handins

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.text
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import robotran.uikit.*

/**
 * Text that is shortened in its middle where there is no room, since names of files often end with the pupil's. Screen
 * readers hear all of it.
 */
@Composable
internal fun ShortenedText(label: String, style: TextStyle, maxLines: Int, modifier: Modifier = Modifier) =
    BoxWithConstraints(modifier.clearAndSetSemantics { text = AnnotatedString(label) }) {
        val whole = style.asWritten()
        val measurer = rememberTextMeasurer()
        val width = constraints.maxWidth
        val shown = remember(label, whole, maxLines, width, measurer) {
            shortenedInMiddle(label) { part ->
                val room = Constraints(maxWidth = width)
                !measurer.measure(part, whole, TextOverflow.Clip, maxLines = maxLines, constraints = room)
                    .hasVisualOverflow
            }
        }
        Text(shown, style = whole, maxLines = maxLines, overflow = TextOverflow.Ellipsis)
    }

/** [label] with as few letters left out of the middle as it takes until it [fits]. More is left of the end. */
internal fun shortenedInMiddle(label: String, fits: (String) -> Boolean): String {
    if (fits(label)) return label
    var min = 0
    var max = label.length - 1
    while (min < max) {
        val middle = (min + max + 1) / 2
        if (fits(withLetters(label, middle))) min = middle else max = middle - 1
    }
    return withLetters(label, min)
}

private fun withLetters(label: String, count: Int): String {
    val head = label.take(count * HEAD_PERCENT / 100).dropLastWhile { it.isHighSurrogate() }
    val tail = label.takeLast(count - count * HEAD_PERCENT / 100).dropWhile { it.isLowSurrogate() }
    return "${head.trimEnd()}…${tail.trimStart()}"
}

private const val HEAD_PERCENT = 40
