package robotran.uikit

import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.Constraints

/**
 * How a word is written under a sign.
 *
 * @property text the word, with hyphens and breaks where it needs them.
 * @property scale how large it is, compared with others.
 */
data class SignLettering(val text: String, val scale: Float = 1f)

/**
 * How [label] are written in [MAX_SIGN_LINES] lines of [width] pixels so that none is broken in its middle: a long word on
 * "sensor" gets a hyphen before it, and what is still too wide or too long is written smaller.
 */
fun TextMeasurer.signLettering(label: String, style: TextStyle, width: Int): SignLettering {
    fun styleOf(scale: Float) = style.copy(fontSize = style.fontSize * scale)

    fun widthOf(part: String, scale: Float = 1f): Int =
        measure(part.trim(), styleOf(scale), softWrap = false, maxLines = 1).size.width

    val text = label.parts().joinToString("") { if (widthOf(it) <= width) it else it.withHyphen() }
    val widest = text.parts().maxBy { widthOf(it) }

    fun fits(scale: Float) = widthOf(widest, scale) <= width &&
        measure(text, styleOf(scale), constraints = Constraints(maxWidth = width)).lineCount <= MAX_SIGN_LINES
    return SignLettering(text, SCALES.firstOrNull(::fits) ?: SCALES.last())
}

/** How many lines are under a sign at most. */
internal const val MAX_SIGN_LINES = 3

/** Down to less than half. */
private val SCALES = List(13) { 1f - it * 0.05f }
private const val HYPHENATED = "sensor"

/** What can be on a line of its own, with the blank, hyphen or break behind it. */
private fun String.parts(): List<String> {
    val ends = indices.filter { this[it] in " -\n" }.map { it + 1 }
    return (listOf(0) + ends + length).zipWithNext { start, end -> substring(start, end) }
}

private fun String.withHyphen(): String {
    val place = lastIndexOf(HYPHENATED)
    return if (place <= 0) this else "${substring(0, place)}-\n${substring(place)}"
}
