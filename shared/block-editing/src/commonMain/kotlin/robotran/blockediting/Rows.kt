package robotran.blockediting

import robotran.robolang.outline.LineRole
import robotran.robolang.outline.ProgramOutline
import robotran.robolang.syntax.RobolangLimits

/**
 * A line of a program that is being edited, and where it is to be among the blocks.
 *
 * @property content the line without its line break.
 * @property lineBreak its line break; null for that of the program.
 * @property origin the index of the line of the program before; null if it is new or has moved.
 */
internal data class Row(
    val content: String,
    val lineBreak: String?,
    val role: LineRole,
    val depth: Int,
    val origin: Int?,
) {
    val isBlank: Boolean get() = role == LineRole.BLANK

    /** This row as a new one, [depth] levels deeper, its indentation changed from [base] to [indentation]. */
    fun moved(base: String, indentation: String, depth: Int): Row = copy(
        content = reindented(base, indentation, depth),
        lineBreak = null,
        depth = this.depth + depth,
        origin = null,
    )

    private fun reindented(base: String, indentation: String, depth: Int): String = when {
        isBlank -> content
        content.startsWith(base) -> indentation + content.substring(base.length)
        else -> INDENTATION.repeat(this.depth + depth) + content.trimStart(::isIndentation)
    }
}

/** The indentation of one level, as the formatter writes it. */
internal const val INDENTATION = "  "

/** Whether a line can begin with [character] before its first word. */
internal fun isIndentation(character: Char): Boolean =
    character == ' ' || character == '\t' || character == '\u000C' || character == '\u00A0'

internal fun indentationOf(content: String): String = content.takeWhile(::isIndentation)

/** The first [count] lines of this outline. */
internal fun ProgramOutline.rows(count: Int): List<Row> = lines.subList(0, count).map { line ->
    val content = line.span.textIn(source)
    Row(content, source.substring(line.span.end, line.end), line.role, line.depth, line.index)
}

/** The rows that open a block without closing it, each with the index behind the last row inside. */
internal fun unclosed(rows: List<Row>): List<IntRange> {
    val found = mutableListOf<IntRange>()
    val open = ArrayDeque<Int>()
    rows.forEachIndexed { index, row ->
        val belongs = row.role == LineRole.BRANCHES || row.role == LineRole.CLOSES
        while (open.isNotEmpty() && rows[open.last()].depth >= row.depth + (if (belongs) 1 else 0)) {
            found += open.removeLast()..index
        }
        if (row.role == LineRole.OPENS) open.addLast(index)
        if (row.role == LineRole.CLOSES) open.removeLastOrNull()
    }
    while (open.isNotEmpty()) found += open.removeLast()..rows.size
    return found
}

/** These rows with an `end`, in the words of [program], for each of the blocks [lacking] one, as [unclosed] finds them. */
internal fun List<Row>.closed(lacking: List<IntRange>, program: BlockProgram): List<Row> {
    if (lacking.isEmpty()) return this
    val rows = toMutableList()
    for (block in lacking) {
        val opener = this[block.first]
        for (index in lastFilled(block) + 1..<block.last) {
            rows[index] = rows[index].copy(depth = minOf(rows[index].depth, opener.depth))
        }
    }
    val ends = lacking.groupBy { block -> lastFilled(block) + 1 }
    return buildList {
        for (index in 0..rows.size) {
            ends[index]?.sortedByDescending { it.first }?.forEach { add(endOf(rows[it.first], program)) }
            rows.getOrNull(index)?.let(::add)
        }
    }
}

/** The last row of [block] that is not blank. */
private fun List<Row>.lastFilled(block: IntRange): Int =
    (block.last - 1 downTo block.first).first { it == block.first || !this[it].isBlank }

private fun endOf(opener: Row, program: BlockProgram): Row {
    val content = indentationOf(opener.content) + program.inWords("end")
    return Row(content, lineBreak = null, LineRole.CLOSES, opener.depth, origin = null)
}

/** Whether a block is nested more deeply than the language allows. */
internal fun isTooDeep(rows: List<Row>): Boolean =
    rows.any { it.role == LineRole.OPENS && it.depth >= RobolangLimits.NESTED_BLOCKS }
