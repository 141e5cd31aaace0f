package robotran.workshop.blocks

import robotran.blockediting.BlockProgram
import robotran.language.source.SourceSpan
import robotran.robolang.words.BlockGroup

/** The value at [span], in the line of [cursor]. */
internal class ValuePlace(val cursor: BlockCursor, val span: SourceSpan)

/** The first plain number of a block that drives, such as the 20 of `forward 20`; null if there is none. */
internal fun BlockProgram.firstLength(): ValuePlace? = outline.lines.firstNotNullOfOrNull { line ->
    val block = blockOfLine(line.index)?.takeIf { it.group == BlockGroup.DRIVE } ?: return@firstNotNullOfOrNull null
    line.editableParts
        .firstOrNull { it.span.textIn(text).toIntOrNull() != null }
        ?.let { ValuePlace(BlockCursor.At(block.id), it.span) }
}
