package robotran.blockediting

import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.ProgramOutline

/** The number of each line, which is that of the block it begins, and the first number that is free. */
internal class LineIds(val ofLines: IntArray, val next: Int)

/**
 * Numbers the first [count] lines of [outline], which was changed from [previous]. Equal lines at both ends keep their
 * numbers. Of those between, a line that is elsewhere now keeps its number, too, and if as many lines are left in both
 * programs, they have changed in place.
 */
internal fun carriedIds(previous: BlockProgram, outline: ProgramOutline, count: Int): LineIds {
    val old = previous.outline.lines.subList(0, previous.lineCount)
    val new = outline.lines.subList(0, count)
    val ids = IntArray(count) { NONE }
    val head = commonLines(old, previous.text, new, outline.source, minOf(old.size, count))
    val tail = commonLines(
        old.asReversed(),
        previous.text,
        new.asReversed(),
        outline.source,
        minOf(old.size, count) - head,
    )
    for (index in 0..<head) ids[index] = previous.lineIds[index]
    for (index in 1..tail) ids[count - index] = previous.lineIds[old.size - index]
    val left = LinkedHashMap<String, ArrayDeque<Int>>()
    for (index in head..<old.size - tail) {
        left.getOrPut(trimmed(old[index], previous.text)) { ArrayDeque() }.addLast(previous.lineIds[index])
    }
    val changed = (head..<count - tail).filter { index ->
        val same = left[trimmed(new[index], outline.source)]?.removeFirstOrNull()
        if (same != null) ids[index] = same
        same == null
    }
    val unmatched = left.values.flatten().sorted()
    var next = previous.nextId
    changed.forEachIndexed { place, index ->
        ids[index] = if (unmatched.size == changed.size) unmatched[place] else next++
    }
    return LineIds(ids, next)
}

private const val NONE = -1

private fun trimmed(line: OutlineLine, source: String): String = line.span.textIn(source).trim()

private fun commonLines(
    old: List<OutlineLine>,
    oldText: String,
    new: List<OutlineLine>,
    newText: String,
    max: Int,
): Int {
    var count = 0
    while (count < max && isSame(old[count], oldText, new[count], newText)) count++
    return count
}

private fun isSame(old: OutlineLine, oldText: String, new: OutlineLine, newText: String): Boolean =
    old.span.length == new.span.length &&
        oldText.regionMatches(old.span.start, newText, new.span.start, old.span.length)
