package robotran.workshop.event

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockId
import robotran.blockediting.palette.PaletteBlock
import robotran.language.source.SourceSpan
import robotran.projects.ProgramView
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockPalette
import robotran.workshop.blocks.BlockStep
import robotran.workshop.blocks.BlockTarget
import robotran.workshop.blocks.DragPayload

/** A user action on the blocks of the current program. Ignored while it is shown as text only, except [ViewChosen]. */
sealed interface BlockEvent : ProgramEvent {
    data class ViewChosen(val view: ProgramView) : BlockEvent

    /** Applies [edit]. If that is impossible, the reason is shown. */
    data class Edited(val edit: BlockEdit) : BlockEvent

    /** Puts [text] at the part whose sheet is open. The sheet stays open. */
    data class Put(val text: String) : BlockEvent

    /** Puts the cursor at a line, or at a [part] of it; null for no line. */
    data class CursorPut(val cursor: BlockCursor?, val part: SourceSpan? = null) : BlockEvent

    /** Selects all blocks from the one that was selected first to [block], if both are in one branch. */
    data class SelectedTo(val block: BlockId) : BlockEvent

    /** Selects [block] and all behind it in its branch. */
    data class StackSelected(val block: BlockId) : BlockEvent

    /** Whether from now on a touch on a block selects all blocks up to it. */
    data class MultiSelectChanged(val isOn: Boolean) : BlockEvent

    data class Stepped(val step: BlockStep) : BlockEvent

    /** Moves the selected blocks by one row. */
    data class Moved(val isUp: Boolean) : BlockEvent

    /** Moves the selected blocks out of the block around, or into the one above. */
    data class Nested(val isOut: Boolean) : BlockEvent

    /** Hides what is inside of [block], or shows it again. */
    data class Folded(val block: BlockId) : BlockEvent

    /** Adds [block] below the cursor; a value goes to the part with the cursor. */
    data class Taken(val block: PaletteBlock) : BlockEvent

    /** Adds the lines of [text] below the cursor; a single value goes to the part with the cursor. */
    data class Pasted(val text: String) : BlockEvent

    /** Opens [sheet]; null closes it. */
    data class DialogShown(val sheet: BlockDialog?) : BlockEvent

    /** Runs [load] at once, from where the robot stands; the program stays as it is. */
    data class SnippetRequested(val load: DragPayload) : BlockEvent

    data class PaletteGroupSelected(val palette: BlockPalette) : BlockEvent

    /** Lets go of [load], which was carried, at [target]. */
    data class Dropped(val load: DragPayload, val target: BlockTarget) : BlockEvent

    data object ErrorDismissed : BlockEvent
}
