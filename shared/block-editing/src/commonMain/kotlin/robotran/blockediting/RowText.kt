package robotran.blockediting

import robotran.robolang.outline.OutlineLine
import robotran.textediting.TextEdit
import robotran.textediting.editBetween

/** The text that [rows] make of [before], and how they change it. */
internal class RowText(private val before: BlockProgram, rows: List<Row>) {
    private val lineBreak = lineBreakOf(before)
    private val isEnded = before.lineCount == 0 || before.outline.lines.let { it[before.lineCount - 1] }.hasBreak
    private val texts: List<String> = rows.mapIndexed { index, row ->
        row.content + if (index < rows.size - 1 || isEnded) breakOf(row, rows.getOrNull(index + 1)) else ""
    }
    private val origins = rows.map { it.origin }

    /** A line break that does not become a single one together with that of an empty line behind it. */
    private fun breakOf(row: Row, next: Row?): String {
        val own = row.lineBreak?.ifEmpty { null } ?: lineBreak
        val joins = own == "\r" && next != null && next.content.isEmpty() && next.lineBreak?.startsWith('\n') != false
        return if (joins) "\n" else own
    }

    /** The offset in the text afterwards at which each row begins, and behind the last one. */
    val starts: IntArray = IntArray(rows.size + 1)

    /** The whole text afterwards. */
    val text: String

    init {
        val lead = before.outline.lines.first().span.start
        starts[0] = lead
        texts.forEachIndexed { index, text -> starts[index + 1] = starts[index] + text.length }
        text = before.text.substring(0, lead) + texts.joinToString("")
    }

    /** The changes, each between two lines that stay. */
    fun changes(): List<TextEdit> {
        val changes = mutableListOf<TextEdit>()
        val lines = before.outline.lines
        var line = 0
        val inserted = StringBuilder()

        fun change(until: Int) {
            val start = if (line < lines.size) lines[line].span.start else before.text.length
            val end = if (until < lines.size) lines[until].span.start else before.text.length
            editBetween(before.text.substring(start, end), inserted.toString())
                ?.let { changes += it.copy(start = it.start + start) }
            inserted.clear()
        }
        origins.forEachIndexed { row, origin ->
            if (origin == null) {
                inserted.append(texts[row])
            } else {
                change(origin)
                line = origin
                inserted.append(texts[row])
                change(origin + 1)
                line = origin + 1
            }
        }
        change(lines.size)
        return changes
    }
}

internal val OutlineLine.hasBreak: Boolean get() = end > span.end

/** The line break that most programs have throughout: that of the first line. */
internal fun lineBreakOf(program: BlockProgram): String {
    val first = program.outline.lines.first()
    return if (first.hasBreak) program.text.substring(first.span.end, first.end) else "\n"
}
