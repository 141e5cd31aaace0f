package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart

/**
 * The smallest pieces of a program in the order of its blocks: words, values, the spaces between them, comments and line
 * breaks. They cover the text without gaps and overlaps.
 */
fun piecesOf(program: BlockProgram): List<SourceSpan> = Pieces(program).found

private class Pieces(program: BlockProgram) {
    val found = mutableListOf<SourceSpan>()
    private var position = 0

    init {
        program.blocks.forEach(::block)
        // A text without any block can still have a byte order mark.
        until(program.outline.lines.last().end)
    }

    private fun block(block: Block) {
        if (block !is Block.Construct) return line(block.head)
        for (slot in block.slots) {
            line(slot.head)
            slot.blocks.forEach(::block)
        }
        block.foot?.let(::line)
    }

    private fun line(line: OutlineLine) {
        until(line.span.start)
        line.parts.forEach(::part)
        line.comment?.let {
            until(it.start)
            until(it.end)
        }
        until(line.span.end)
        until(line.end)
    }

    private fun part(part: PhrasePart) {
        if (part is PhrasePart.Value) {
            part.value.parts.forEach(::part)
        } else {
            until(part.span.start)
            until(part.span.end)
        }
    }

    private fun until(end: Int) {
        check(end >= position) { "The pieces of a program overlap at $end." }
        if (end > position) found += SourceSpan(position, end)
        position = end
    }
}
