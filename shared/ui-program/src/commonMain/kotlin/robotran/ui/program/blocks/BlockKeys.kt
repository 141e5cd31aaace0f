package robotran.ui.program.blocks

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.key.utf16CodePoint
import androidx.compose.ui.platform.ClipboardManager
import robotran.blockediting.Block
import robotran.blockediting.BlockEdit
import robotran.robolang.outline.PhrasePart
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockStep
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.editableParts
import robotran.workshop.blocks.lineOf
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent

/**
 * The keys of the list of blocks. Arrows walk the tree: up and down over lines, towards the end of a line into its
 * parts, back out of it and out of the block around. Enter edits, Space folds, Alt and arrows move blocks, Alt and
 * Enter runs them at once.
 *
 * @param dragging what a mouse carries; Escape puts it back.
 */
internal class BlockKeys(
    private val scope: BlockScope,
    private val clipboard: ClipboardManager,
    private val dragging: BlockDragging,
    private val onProgram: (ProgramEvent) -> Unit,
) {
    private val state get() = scope.state
    private val inwards get() = if (dragging.isRightToLeft) Key.DirectionLeft else Key.DirectionRight
    private val outwards get() = if (dragging.isRightToLeft) Key.DirectionRight else Key.DirectionLeft

    /** Whether [event] was a key of the blocks. */
    fun handle(event: KeyEvent): Boolean {
        if (event.type != KeyEventType.KeyDown) return false
        val control = event.isCtrlPressed || event.isMetaPressed
        return when {
            control -> withControl(event)
            event.isAltPressed -> withAlt(event.key)
            event.isShiftPressed && withShift(event.key) -> true
            else -> alone(event)
        }
    }

    private fun alone(event: KeyEvent): Boolean {
        val key = event.key
        val step = STEPS[key]
        when {
            step != null -> send(BlockEvent.Stepped(step))
            key == inwards -> send(BlockEvent.Stepped(BlockStep.RIGHT))
            key == outwards -> send(BlockEvent.Stepped(BlockStep.LEFT))
            key == Key.PageUp -> repeat(PAGE) { send(BlockEvent.Stepped(BlockStep.UP)) }
            key == Key.PageDown -> repeat(PAGE) { send(BlockEvent.Stepped(BlockStep.DOWN)) }
            key == Key.Enter || key == Key.NumPadEnter -> enter()
            key == Key.Spacebar -> fold()
            key == Key.Delete || key == Key.Backspace -> delete()
            key == Key.Insert || event.utf16CodePoint == '/'.code -> scope.show(BlockDialog.Palette)
            key == Key.F2 || key == Key.Menu -> actions()
            key == Key.F9 -> lineNumber()?.let { onProgram(ProgramEvent.BreakpointToggled(it)) }
            key == Key.Escape -> return escape()
            else -> return false
        }
        return true
    }

    private fun withShift(key: Key): Boolean {
        when (key) {
            Key.DirectionUp -> extend(-1)
            Key.DirectionDown -> extend(1)
            Key.MoveEnd -> state.cursor?.let { send(BlockEvent.StackSelected(it.block)) }
            Key.F10 -> actions()
            else -> return false
        }
        return true
    }

    private fun withAlt(key: Key): Boolean {
        when (key) {
            Key.DirectionUp -> send(BlockEvent.Moved(isUp = true))
            Key.DirectionDown -> send(BlockEvent.Moved(isUp = false))
            inwards -> send(BlockEvent.Nested(isOut = false))
            outwards -> send(BlockEvent.Nested(isOut = true))
            Key.Enter, Key.NumPadEnter -> state.run?.let { scope.doNow(DragPayload.Blocks(it)) }
            else -> return false
        }
        return true
    }

    private fun withControl(event: KeyEvent): Boolean {
        when (event.key) {
            Key.Z -> onProgram(if (event.isShiftPressed) ProgramEvent.Redone else ProgramEvent.Undone)
            Key.Y -> onProgram(ProgramEvent.Redone)
            Key.A -> selectAll()
            Key.C -> clipboard.copy(scope)
            Key.X -> if (clipboard.copy(scope)) delete()
            Key.V -> clipboard.getText()?.text?.let(scope::paste)
            Key.D -> state.run?.let { scope.edit(BlockEdit.Duplicate(it)) }
            else -> return false
        }
        return true
    }

    /** Opens the sheet of the part, or of the first part of the line, or what can be done to the block. */
    private fun enter() {
        val cursor = state.cursor ?: return scope.show(BlockDialog.Palette)
        val part = state.part ?: state.program.lineOf(cursor)?.editableParts?.firstOrNull()?.span
        scope.show(part?.let { BlockDialog.Part(it) } ?: BlockDialog.Actions(cursor.block))
    }

    private fun actions() {
        state.cursor?.let { scope.show(BlockDialog.Actions(it.block)) }
    }

    private fun fold() {
        val block = state.cursor?.let { state.program[it.block] } as? Block.Construct ?: return
        send(BlockEvent.Folded(block.id))
    }

    /** Deletes the blocks, or replaces the value with one that fits. */
    private fun delete() {
        val part = state.part?.let { state.program.partAt(it) } as? PhrasePart.Value
        when {
            part != null -> scope.edit(BlockEdit.ClearValue(part.span))
            state.cursor is BlockCursor.At -> scope.edit(BlockEdit.Delete(state.selected.toSet()))
        }
    }

    private fun extend(by: Int) {
        val at = (state.cursor as? BlockCursor.At)?.let { state.program.placeOf(it.block) } ?: return
        val siblings = state.program.blocksAt(at.parent, at.slot).orEmpty()
        siblings.getOrNull(at.index + by)?.let { send(BlockEvent.SelectedTo(it.id)) }
    }

    /** All blocks of the branch. */
    private fun selectAll() {
        val place = state.cursor?.let { state.program.placeOf(it.block) }
        val siblings = state.program.blocksAt(place?.parent, place?.slot ?: 0)
        siblings?.firstOrNull()?.let { send(BlockEvent.StackSelected(it.id)) }
    }

    private fun escape(): Boolean {
        when {
            dragging.finger != null -> dragging.cancel()
            state.isChoosing -> send(BlockEvent.MultiSelectChanged(false))
            state.error != null -> send(BlockEvent.ErrorDismissed)
            state.sheet != null -> scope.show(null)
            state.selected.size > 1 -> state.cursor?.let { send(BlockEvent.CursorPut(it)) }
            else -> return false
        }
        return true
    }

    private fun lineNumber(): Int? = state.cursor?.let { state.program.lineOf(it) }?.let { it.index + 1 }

    private fun send(event: BlockEvent) = scope.onEvent(event)

    private companion object {
        val STEPS = mapOf(
            Key.DirectionUp to BlockStep.UP,
            Key.DirectionDown to BlockStep.DOWN,
            Key.MoveHome to BlockStep.FIRST,
            Key.MoveEnd to BlockStep.LAST,
        )

        /** Lines that Page Up and Page Down walk. */
        const val PAGE = 10
    }
}
