package robotran.workshop.blocks

import androidx.compose.runtime.Immutable
import robotran.blockediting.Block
import robotran.blockediting.BlockEditError
import robotran.blockediting.BlockId
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.blockediting.BlockRun
import robotran.blockediting.palette.PaletteBlock
import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.robolang.words.BlockGroup

/**
 * The blocks of a Robolang program and what the pupil does with them.
 *
 * @property list the blocks of the current text.
 * @property language the language of the messages in [list].
 * @property cursor the line that the keyboard is at; null if it is at none.
 * @property part the value, name or word of that line that the keyboard is at; null if it is at the whole line.
 * @property selected neighbouring blocks of one branch, in order. What the pupil does to one of them is done to all.
 * @property anchor the selected block from which more are selected; null for the first one.
 * @property isChoosing whether a touch on a block selects all up to it.
 * @property sheet what covers the lower part of the blocks; null for nothing.
 * @property said what the last edit has done, in words for a screen reader; null if nothing.
 * @property error why the last edit was impossible, until the next one or until the pupil closes the message.
 */
@Immutable
data class BlocksState(
    val list: BlockList,
    val language: Language,
    val cursor: BlockCursor? = null,
    val part: SourceSpan? = null,
    val selected: List<BlockId> = emptyList(),
    val anchor: BlockId? = null,
    val isChoosing: Boolean = false,
    val sheet: BlockDialog? = null,
    val palette: BlockPalette = BlockPalette(),
    val said: String? = null,
    val error: BlockEditError? = null,
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
sealed interface BlockDialog {
    /** The blocks that can be added. */
    data object Palette : BlockDialog

    /** What can be done to a block. */
    data class Actions(val block: BlockId) : BlockDialog

    /** A value, a name, a text or a choice. */
    data class Part(val span: SourceSpan) : BlockDialog

    /** The comment of the line with this index. */
    data class Note(val line: Int) : BlockDialog

    /** The text of the line with this index. */
    data class Line(val line: Int) : BlockDialog
}

/**
 * What the palette shows.
 *
 * @property query what is searched for in all groups; empty for all blocks of [group].
 */
@Immutable
data class BlockPalette(val group: BlockGroup = BlockGroup.DRIVE, val query: String = "")

/** What a finger or a mouse carries, or what runs at once. */
sealed interface DragPayload {
    data class Blocks(val run: BlockRun) : DragPayload

    /** The value at [span] of the program. */
    data class Value(val span: SourceSpan) : DragPayload

    /** A block or a value of the palette. */
    data class New(val block: PaletteBlock) : DragPayload
}

/** Where something that is carried goes. */
sealed interface BlockTarget {
    /** Blocks go to [place]. */
    data class Between(val place: BlockPlace) : BlockTarget

    /** A value goes to the part at [span]. */
    data class Socket(val span: SourceSpan) : BlockTarget

    /** Blocks are deleted, and a value is replaced by one that fits. */
    data object Bin : BlockTarget
}
