package robotran.blockediting

import robotran.brick.kind.BrickKind
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.LineRole
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.ProgramOutline
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.Vocabulary

/**
 * Reads a Robolang text as blocks, in time linear in its length. Never throws for any [text].
 *
 * @param messages the mistakes in the pupil's language.
 * @param previous the program before the text was changed, so that blocks keep their ids.
 * @param shown the words that blocks show; null for those of [previous], or else of the text.
 * @param brick the brick of the robot that it is for.
 */
fun blocksOf(
    text: String,
    messages: RobolangMessages,
    previous: BlockProgram? = null,
    shown: Vocabulary? = null,
    brick: BrickKind = previous?.brick ?: BrickKind.default,
): BlockProgram = blocksOf(outlineRobolang(text, messages, brick = brick), messages, previous, shown)

/** Reads [text] as blocks that belong to [program]: written in its words, or in those of English. */
internal fun fragmentOf(program: BlockProgram, text: String): BlockProgram {
    val written = program.inWords(text)
    val outline = outlineRobolang(written, program.messages, program.vocabulary, program.brick)
    return blocksOf(outline, program.messages, previous = null)
}

internal fun blocksOf(
    outline: ProgramOutline,
    messages: RobolangMessages,
    previous: BlockProgram?,
    shown: Vocabulary? = null,
): BlockProgram {
    val count = linesOfBlocks(outline)
    val ids = if (previous == null) LineIds(IntArray(count) { it }, count) else carriedIds(previous, outline, count)
    val blocks = BlockReader(outline.lines.subList(0, count), ids.ofLines).read()
    val words = shown ?: previous?.shown ?: outline.parsed?.vocabulary ?: Vocabulary.ENGLISH
    return BlockProgram(outline, blocks, words, ids.ofLines, ids.next, messages)
}

/** The text of a program, put together from its blocks. It is the text that the program was made of. */
fun textOf(program: BlockProgram): String =
    buildString(program.text.length) { piecesOf(program).forEach { append(program.text, it.start, it.end) } }

/** The number of lines without the empty one behind the last line break. */
private fun linesOfBlocks(outline: ProgramOutline): Int {
    val last = outline.lines.last()
    return if (last.span.length == 0) outline.lines.size - 1 else outline.lines.size
}

/** Groups lines into blocks. The depth of recursion is the nesting of blocks, which the language limits. */
private class BlockReader(private val lines: List<OutlineLine>, private val ids: IntArray) {
    private var next = 0

    fun read(): List<Block> = blocks(depth = 0)

    private fun blocks(depth: Int): List<Block> {
        val found = mutableListOf<Block>()
        while (next < lines.size && belongs(lines[next], depth)) found += block(lines[next++])
        return found
    }

    private fun belongs(line: OutlineLine, depth: Int): Boolean =
        line.depth >= depth && line.role != LineRole.BRANCHES && line.role != LineRole.CLOSES

    private fun block(line: OutlineLine): Block {
        val id = BlockId(ids[line.index])
        return when (line.role) {
            LineRole.OPENS -> construct(id, line)
            LineRole.BLANK -> Block.Blank(id, line)
            LineRole.COMMENT -> Block.Comment(id, line)
            else -> if (line.form == null) Block.Loose(id, line) else Block.Command(id, line)
        }
    }

    private fun construct(id: BlockId, head: OutlineLine): Block {
        val slots = mutableListOf(BlockSlot(head, blocks(head.depth + 1)))
        while (role(head.depth) == LineRole.BRANCHES) slots += BlockSlot(lines[next++], blocks(head.depth + 1))
        val foot = if (role(head.depth) == LineRole.CLOSES) lines[next++] else null
        return Block.Construct(id, head, slots, foot)
    }

    /** The role of the next line, if it is as deep as the construct that is being read. */
    private fun role(depth: Int): LineRole? = lines.getOrNull(next)?.takeIf { it.depth == depth }?.role
}
