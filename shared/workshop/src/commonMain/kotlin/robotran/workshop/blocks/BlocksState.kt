package robotran.workshop.blocks

import androidx.compose.runtime.Immutable
import robotran.blockediting.Block
import robotran.blockediting.BlockGroup
import robotran.blockediting.BlockId
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.blockediting.BlockRefusal
import robotran.blockediting.BlockRun
import robotran.blockediting.palette.PaletteBlock
import robotran.language.Language
import robotran.robolang.outline.SourceSpan

/**
 * The blocks of a Robolang program and what the pupil does with them.
 *
 * @property list the blocks of the current text.
 * @property language the language of the messages in [list].
 * @property cursor the line that the keyboard is at; null if it is at none.
 * @property part the value, name or word of that line that the keyboard is at; null if it is at the whole line.
 * @property selected neighbouring blocks of one branch, in order. What the pupil does to one of them is done to all.
 * @property sheet what covers the lower part of the blocks; null for nothing.
 * @property drag what a finger carries; null if nothing.
 * @property refusal why the last edit was impossible, until the next one or until the pupil closes the message.
 */
@Immutable
data class BlocksState(
    val list: BlockList,
    val language: Language,
    val cursor: BlockCursor? = null,
    val part: SourceSpan? = null,
    val selected: List<BlockId> = emptyList(),
    val sheet: BlockSheet? = null,
    val palette: BlockPalette = BlockPalette(),
    val drag: BlockDrag? = null,
    val refusal: BlockRefusal? = null,
) {
    val program: BlockProgram get() = list.program

    /** The blocks that an action on [block] is about: all selected ones if it is among them. */
    fun runOf(block: BlockId): BlockRun =
        if (block in selected) BlockRun(selected.first(), selected.size) else BlockRun(block)

    /** The same for the blocks that the keyboard is at; null if it is at none. */
    val run: BlockRun? get() = cursor?.let { runOf(it.block) }
}

/** The blocks of [run], without those inside of them; empty if there are none. */
fun BlockProgram.blocksIn(run: BlockRun): List<Block> {
    val place = placeOf(run.first) ?: return emptyList()
    return blocksAt(place.parent, place.slot).orEmpty().drop(place.index).take(run.count)
}

/** What the pupil edits in a sheet below the blocks. */
sealed interface BlockSheet {
    /** The blocks that can be added. */
    data object Palette : BlockSheet

    /** What can be done to a block. */
    data class Actions(val block: BlockId) : BlockSheet

    /** A value, a name, a text or a choice. */
    data class Part(val span: SourceSpan) : BlockSheet

    /** The comment of the line with this index. */
    data class Note(val line: Int) : BlockSheet

    /** The text of the line with this index. */
    data class Line(val line: Int) : BlockSheet
}

/**
 * What the palette shows.
 *
 * @property query what is searched for in all groups; empty for all blocks of [group].
 */
@Immutable
data class BlockPalette(val group: BlockGroup = BlockGroup.DRIVE, val query: String = "")

/**
 * Blocks that a finger or a mouse carries.
 *
 * @property place where they land if they are let go; null if nowhere.
 */
@Immutable
data class BlockDrag(val load: BlockLoad, val place: BlockPlace? = null)

/** Blocks that are carried, or run at once. */
sealed interface BlockLoad {
    data class Blocks(val run: BlockRun) : BlockLoad

    data class New(val block: PaletteBlock) : BlockLoad
}
