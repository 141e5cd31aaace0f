package robotran.workshop.programs

import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockProgram
import robotran.languagesupport.TextLines
import robotran.textediting.movedWith

/**
 * Lines with [breakpoints], from 1, after the blocks [before] have become those of [done]. A breakpoint stays with its
 * block, also if the block moves; one at an `else` or `end` moves with the text.
 */
internal fun movedBreakpoints(breakpoints: Set<Int>, before: BlockProgram, done: BlockEditResult.Success): Set<Int> =
    breakpoints.mapNotNullTo(mutableSetOf()) { line ->
        val block = before.blockOfLine(line - 1)
        if (block != null && block.head.index == line - 1) {
            done.program[block.id]?.let { it.head.index + 1 }
        } else {
            movedWithText(line, before.text, done)
        }
    }

/** The changes do not overlap, so the last one comes first: the places of the others stay right. */
private fun movedWithText(line: Int, text: String, done: BlockEditResult.Success): Int? {
    var now = text
    var marks = setOf(line)
    for (change in done.changes.asReversed()) {
        marks = marks.movedWith(change, TextLines(now))
        now = change.applyTo(now)
    }
    return marks.firstOrNull()
}
