package robotran.blockediting

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceSpan
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ProgramOutline
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf
import robotran.robolang.words.written

/**
 * A Robolang text as blocks. Immutable: an edit makes another one, see [apply].
 *
 * @property outline the text, line by line.
 * @property blocks the blocks that are in no other.
 * @property shown the words that its blocks show, which need not be those that it is written in.
 */
class BlockProgram internal constructor(
    val outline: ProgramOutline,
    val blocks: List<Block>,
    val shown: Vocabulary,
    internal val lineIds: IntArray,
    internal val nextId: Int,
    internal val messages: RobolangMessages,
) {
    val text: String get() = outline.source

    /** The brick of the robot that it is for. */
    val brick: BrickKind get() = outline.brick

    /** The words that it is written in; those that its blocks show as long as nothing in it tells. */
    val vocabulary: Vocabulary by lazy {
        val read = outline.parsed?.vocabulary ?: Vocabulary.ENGLISH
        if (read === Vocabulary.ENGLISH && shown !== read) vocabularyOf(text, unsure = shown) else read
    }

    /** [english], a piece of a program, in the words of this one. */
    internal fun inWords(english: String): String =
        vocabulary.written(english) { word -> outline.names.any { it.key == word } }

    /** All blocks, each before those inside it. */
    val all: List<Block> by lazy { buildList { addAllOf(blocks) } }

    private val places: Map<BlockId, BlockPlace> by lazy { buildMap { putPlacesOf(blocks, null, 0) } }
    private val byId: Map<BlockId, Block> by lazy { all.associateBy { it.id } }

    /** The number of lines that belong to blocks: all but the empty one behind the last line break. */
    internal val lineCount: Int get() = lineIds.size

    operator fun get(id: BlockId): Block? = byId[id]

    /** Where the block [id] stands; null if there is none. */
    fun placeOf(id: BlockId): BlockPlace? = places[id]

    /** The blocks of one branch; null if there is no such branch. */
    fun blocksAt(parent: BlockId?, slot: Int): List<Block>? {
        if (parent == null) return blocks.takeIf { slot == 0 }
        return (byId[parent] as? Block.Construct)?.slots?.getOrNull(slot)?.blocks
    }

    /** The place behind the last block of a branch; null if there is no such branch. */
    fun endOf(parent: BlockId?, slot: Int = 0): BlockPlace? =
        blocksAt(parent, slot)?.let { BlockPlace(parent, slot, it.size) }

    /** The innermost block that the line [index] belongs to; null behind the last line. */
    fun blockOfLine(index: Int): Block? {
        var found: Block? = null
        var inside = blocks
        while (true) {
            val next = inside.getOrNull(inside.binarySearch { it.compareTo(index) }) ?: return found
            found = next
            inside = (next as? Block.Construct)?.slots?.lastOrNull { it.head.index < index }?.blocks ?: return found
        }
    }

    /** The line that the offset of the text is in. */
    fun lineAt(offset: Int): OutlineLine {
        val lines = outline.lines
        val place = lines.binarySearch { if (it.span.start <= offset) -1 else 1 }
        return lines[(-place - 2).coerceAtLeast(0)]
    }

    /** The part of a line with exactly the place [span]; null if there is none. */
    fun partAt(span: SourceSpan): PhrasePart? = lineAt(span.start).parts.firstNotNullOfOrNull { partAt(it, span) }

    /** The names that a line at [place] may use; null if there is no such place. */
    fun namesAt(place: BlockPlace): List<DeclaredName>? = lineIndexOf(place)?.let(outline::namesBefore)

    /** The index of the line before which a block at [place] begins. */
    internal fun lineIndexOf(place: BlockPlace): Int? {
        val siblings = blocksAt(place.parent, place.slot) ?: return null
        if (place.index !in 0..siblings.size) return null
        siblings.getOrNull(place.index)?.let { return it.head.index }
        siblings.lastOrNull()?.let { return it.lines.last + 1 }
        val parent = place.parent ?: return 0
        return (get(parent) as Block.Construct).slots[place.slot].head.index + 1
    }

    private fun Block.compareTo(line: Int): Int = when {
        lines.last < line -> -1
        lines.first > line -> 1
        else -> 0
    }

    private fun MutableList<Block>.addAllOf(blocks: List<Block>) {
        for (block in blocks) {
            add(block)
            if (block is Block.Construct) block.slots.forEach { addAllOf(it.blocks) }
        }
    }

    private fun MutableMap<BlockId, BlockPlace>.putPlacesOf(blocks: List<Block>, parent: BlockId?, slot: Int) {
        blocks.forEachIndexed { index, block ->
            put(block.id, BlockPlace(parent, slot, index))
            if (block !is Block.Construct) return@forEachIndexed
            block.slots.forEachIndexed { inner, branch -> putPlacesOf(branch.blocks, block.id, inner) }
        }
    }
}

private fun partAt(part: PhrasePart, span: SourceSpan): PhrasePart? = when {
    part is PhrasePart.Value && span in part.span -> {
        part.value.parts.takeIf { part.span != span }.let { inner ->
            if (inner == null) part else inner.firstNotNullOfOrNull { partAt(it, span) }
        }
    }

    else -> part.takeIf { it.span == span }
}
