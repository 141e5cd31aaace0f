package robotran.workshop.programs

import robotran.blockediting.BlockId
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.at

internal fun BlocksState.nowhere(): BlocksState =
    copy(cursor = null, part = null, selected = emptyList(), anchor = null, isChoosing = false)

/** The blocks from the one that was selected first to [block], which has the cursor then. */
internal fun BlocksState.selectedTo(block: BlockId): BlocksState {
    val place = program.placeOf(block) ?: return this
    val first = anchor ?: selected.firstOrNull()
    val from = first?.let(program::placeOf) ?: return at(BlockCursor.At(block))
    if (from.parent != place.parent || from.slot != place.slot) return at(BlockCursor.At(block))
    val siblings = program.blocksAt(place.parent, place.slot).orEmpty()
    val range = minOf(from.index, place.index)..maxOf(from.index, place.index)
    return copy(
        cursor = BlockCursor.At(block),
        part = null,
        selected = siblings.slice(range).map { it.id },
        anchor = first,
    )
}

internal fun BlocksState.selectedStack(block: BlockId): BlocksState {
    val place = program.placeOf(block) ?: return this
    val siblings = program.blocksAt(place.parent, place.slot).orEmpty()
    return copy(
        cursor = BlockCursor.At(block),
        part = null,
        selected = siblings.drop(place.index).map { it.id },
        anchor = block,
    )
}
