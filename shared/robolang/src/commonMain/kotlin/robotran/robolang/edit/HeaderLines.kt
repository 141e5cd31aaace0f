package robotran.robolang.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionKind
import robotran.languagesupport.TextLines
import robotran.robolang.words.LineForm
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.KINDS as BY_KEYWORD

/**
 * What the header of a program says.
 *
 * @property isInside whether the line in question is a line of the header.
 * @property brick the brick that it names; null if it names none.
 */
internal class HeaderLines(val isInside: Boolean, val brick: BrickKind?)

/** Looks for the header of [lines], which is near its top, and whether [line] is inside it. */
internal fun headerAt(lines: TextLines, line: Int, vocabulary: Vocabulary): HeaderLines {
    var first = -1
    var brick: BrickKind? = null
    for (index in 0..<minOf(lines.count, MAX_LINES)) {
        val words = lines.line(index).substringBefore("//").trim().split(' ').filter { it.isNotEmpty() }
            .map { vocabulary.keyword(it)?.text ?: it.lowercase() }
        when {
            words == listOf("robot") && first < 0 -> first = index
            first >= 0 && words == listOf("end") -> return HeaderLines(line in first + 1..<index, brick)
            first >= 0 && words.size == 2 && words.first() == "brick" -> brick = KINDS[words.last()] ?: brick
        }
    }
    return HeaderLines(first >= 0 && line in first + 1..first + LONGEST, brick)
}

/** The lines that a header for [brick] can have. */
internal fun settingsOn(brick: BrickKind): List<Completion> {
    val settings = LineForm.entries.filter { it.isSetting }.mapNotNull { it.exampleOn(brick) }
    val otherBricks = BrickKind.entries.mapNotNull { LineForm.BRICK.exampleOn(it) }
    return (settings + otherBricks).distinct().map { Completion(it, CompletionKind.WORD) }
}

private val KINDS = BY_KEYWORD.mapKeys { it.key.text }

private const val MAX_LINES = 500

/** The lines of a header that has no `end` yet. */
private const val LONGEST = 6
