package robotran.workshop.blocks

import robotran.blockediting.Block
import robotran.blockediting.BlockPlace
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart

/** A step of the keyboard through the tree of blocks. */
enum class BlockStep {
    UP,
    DOWN,

    /** To the part before, or out of the block around. */
    LEFT,

    /** To the next part of the line. */
    RIGHT,
    FIRST,
    LAST,
}

/** What a pupil can edit in this line, each value before its own parts. */
val OutlineLine.editableParts: List<PhrasePart> get() = parts.flatMap(::editable)

private fun editable(part: PhrasePart): List<PhrasePart> = when (part) {
    is PhrasePart.Word -> emptyList()
    is PhrasePart.Choice, is PhrasePart.NamePart, is PhrasePart.Text -> listOf(part)
    is PhrasePart.Value -> listOf(part) + part.value.parts.flatMap(::editable).filter { it.span != part.span }
}

/** The state after the keyboard made [step]; the same if there is nothing in that direction. */
fun BlocksState.stepped(step: BlockStep): BlocksState {
    val rows = list.rows
    val current = cursor?.let(list::rowOf)
    return when (step) {
        BlockStep.UP -> at(rows.take(current ?: rows.size).lastOrNull { it.cursor != null })
        BlockStep.DOWN -> at(rows.drop(current?.plus(1) ?: 0).firstOrNull { it.cursor != null })
        BlockStep.FIRST -> at(rows.firstOrNull { it.cursor != null })
        BlockStep.LAST -> at(rows.lastOrNull { it.cursor != null })
        BlockStep.RIGHT -> toPart(1)
        BlockStep.LEFT -> if (part == null) outwards() else toPart(-1)
    }
}

private fun BlocksState.at(row: BlockRow?): BlocksState = if (row == null) this else at(checkNotNull(row.cursor))

/** This state with the keyboard at the whole line of [cursor], and its block selected. */
fun BlocksState.at(cursor: BlockCursor): BlocksState = copy(
    cursor = cursor,
    part = null,
    selected = listOf(cursor.block).takeIf { cursor is BlockCursor.At }.orEmpty(),
    anchor = null,
)

private fun BlocksState.toPart(by: Int): BlocksState {
    val parts = cursor?.let(program::lineOf)?.editableParts.orEmpty()
    val next = parts.indexOfFirst { it.span == part } + by
    return when {
        next < 0 -> copy(part = null)
        next >= parts.size -> this
        else -> copy(part = parts[next].span)
    }
}

private fun BlocksState.outwards(): BlocksState {
    val here = cursor ?: return this
    if (here !is BlockCursor.At) return at(BlockCursor.At(here.block))
    val place = program.placeOf(here.block) ?: return this
    val parent = place.parent ?: return this
    return at(if (place.slot == 0) BlockCursor.At(parent) else BlockCursor.Branch(parent, place.slot))
}

/** Where the selected blocks go if they move by one row; null if they cannot. */
fun BlocksState.placeBeyond(isUp: Boolean): BlockPlace? {
    val first = selected.firstOrNull() ?: return null
    if (isUp) {
        val row = list.rowOf(BlockCursor.At(first)) ?: return null
        return list.rows.getOrNull(row - 1)?.placeAbove(program)
    }
    val last = selected.last()
    val row = list.rowOf(BlockCursor.End(last)) ?: list.rowOf(BlockCursor.At(last)) ?: return null
    return list.rows.getOrNull(row + 1)?.placeBelow(program)
}

/** Where the selected blocks go if they leave the block around, or enter the one above; null if they cannot. */
fun BlocksState.placeNested(isOut: Boolean): BlockPlace? {
    val here = selected.firstOrNull()?.let(program::placeOf) ?: return null
    if (isOut) return here.parent?.let(program::placeOf)?.next
    val above = program.blocksAt(here.parent, here.slot).orEmpty().take(here.index).lastOrNull { it !is Block.Blank }
    return (above as? Block.Construct)?.let { program.endOf(it.id, it.slots.lastIndex) }
}

/** Where a new block goes: below the line that the keyboard is at, otherwise at the end. */
val BlocksState.placeForNew: BlockPlace
    get() = cursor?.let(list::rowOf)?.let { list.rows[it].placeBelow(program) } ?: checkNotNull(program.endOf(null))
