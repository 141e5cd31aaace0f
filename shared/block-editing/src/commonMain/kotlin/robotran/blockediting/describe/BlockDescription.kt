package robotran.blockediting.describe

import robotran.blockediting.Block
import robotran.blockediting.BlockId
import robotran.blockediting.BlockProgram
import robotran.blockediting.messages.BlockMessages
import robotran.blockediting.shown.ShownLine
import robotran.robolang.RobolangWords
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.written

/** What a block or a part of it is to a screen reader. */
enum class BlockRole {
    /** A block of one line. */
    TREE_ITEM,

    /** A block with others inside. */
    TREE_BRANCH,

    /** Something to read only: a word. */
    TEXT,

    /** A value, a name or a text to edit. */
    INPUT,

    /** A menu of words. */
    MENU,
}

/**
 * A block for a screen reader.
 *
 * @property level how deeply it is nested, from 1.
 * @property position its position among its neighbours, from 1.
 * @property siblings the number of its neighbours with itself.
 * @property sentence the block in words, such as `repeat 4 times, level 2, 3 blocks inside`.
 * @property words the [sentence] without the level, for screen readers that say that of themselves.
 * @property context the block around it, such as `in repeat 4 times`; null if there is none.
 */
data class BlockDescription(
    val role: BlockRole,
    val level: Int,
    val position: Int,
    val siblings: Int,
    val sentence: String,
    val words: String,
    val context: String?,
)

/** A part of a block for a screen reader. */
data class PartDescription(val role: BlockRole, val sentence: String)

/** Describes the block [id]; null if there is none. */
fun describe(program: BlockProgram, id: BlockId, messages: BlockMessages): BlockDescription? {
    val block = program[id] ?: return null
    val place = checkNotNull(program.placeOf(id))
    val parent = place.parent?.let { program[it] }
    val level = block.head.depth + 1
    return BlockDescription(
        if (block is Block.Construct) BlockRole.TREE_BRANCH else BlockRole.TREE_ITEM,
        level,
        place.index + 1,
        checkNotNull(program.blocksAt(place.parent, place.slot)).size,
        sentence(program, block, messages, messages.level(level)),
        sentence(program, block, messages, level = null),
        parent?.let { messages.isIn(spoken(program, (it as Block.Construct).slots[place.slot].head)) },
    )
}

/** Describes the branch [slot] of the construct [id], such as its `else`; null if there is none. */
fun describe(program: BlockProgram, id: BlockId, slot: Int, messages: BlockMessages): BlockDescription? {
    val construct = program[id] as? Block.Construct ?: return null
    val branch = construct.slots.getOrNull(slot) ?: return null
    val inside = messages.inside(branch.blocks.count(::counts))
    val line = spoken(program, branch.head)
    return BlockDescription(
        BlockRole.TREE_BRANCH,
        construct.head.depth + 1,
        slot + 1,
        construct.slots.size,
        listOf(line, messages.level(construct.head.depth + 1), inside).joinToString(),
        listOf(line, inside).joinToString(),
        messages.isIn(spoken(program, construct.head)),
    )
}

/** Describes a part of a line. */
fun describe(program: BlockProgram, part: PhrasePart, messages: BlockMessages): PartDescription {
    val line = ShownLine(program, program.lineAt(part.span.start))
    val text = line.labelOf(part)
    return when (part) {
        is PhrasePart.Word -> PartDescription(BlockRole.TEXT, text)
        is PhrasePart.Choice -> {
            val options = part.options.map { line.optionOf(part, it) }
            PartDescription(BlockRole.MENU, "$text, ${messages.choice(options)}")
        }

        is PhrasePart.Value -> {
            val unit = part.use.unit?.let { " ${program.shown.written(it)}" }.orEmpty()
            PartDescription(BlockRole.INPUT, "$text$unit, ${messages.kind(part.use.kind)}")
        }

        is PhrasePart.NamePart, is PhrasePart.Text -> PartDescription(BlockRole.INPUT, text)
    }
}

/** Where the block is: its place among its neighbours, and the block around it, such as `2 of 5 in repeat 4 times`. */
fun BlockDescription.place(messages: BlockMessages): String =
    listOfNotNull(messages.position(position, siblings), context).joinToString(" ")

private fun sentence(program: BlockProgram, block: Block, messages: BlockMessages, level: String?): String {
    val head = block.head
    val note = head.comment?.textIn(program.text)?.removePrefix("//")?.trim()
    val line = when (block) {
        is Block.Blank -> messages.emptyLine()
        is Block.Comment -> messages.note(note.orEmpty())
        is Block.Loose -> messages.mistake(written(program, head), head.error?.message)
        is Block.Command, is Block.Construct -> spoken(program, head)
    }
    val inside = if (block is Block.Construct) {
        messages.inside(
            block.slots.sumOf { slot ->
                slot.blocks.count(::counts)
            },
        )
    } else {
        null
    }
    val noteText = note?.takeIf { block is Block.Command || block is Block.Construct }?.let(messages::note)
    val parts = listOfNotNull(line, level, inside, noteText)
    val error = head.error?.message?.takeIf { block is Block.Command || block is Block.Construct }
    return parts.joinToString(", ") + error?.let { ". $it" }.orEmpty()
}

private fun counts(block: Block): Boolean = block !is Block.Blank && block !is Block.Comment

/** A line without its comment, its words apart by one space. */
private fun written(program: BlockProgram, line: OutlineLine): String {
    val end = line.comment?.start ?: line.span.end
    return program.text.substring(line.span.start, end).trim().split(SPACES).joinToString(" ")
}

/** A line in words, with the unit of a number that is written without it. */
internal fun spoken(program: BlockProgram, line: OutlineLine): String {
    if (line.form == null) return written(program, line)
    val last = line.parts.lastOrNull() as? PhrasePart.Value
    val unit = last?.use?.unit?.takeIf { it in RobolangWords.keywords }
    return ShownLine(program, line).sentence + unit?.let { " ${program.shown.written(it)}" }.orEmpty()
}

private val SPACES = Regex("\\s+")
