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
import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.text.AnnotatedString
import robotran.blockediting.BlockEdit
import robotran.blockediting.copied
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockLoad
import robotran.workshop.blocks.BlockSheet
import robotran.workshop.blocks.BlockStep
import robotran.workshop.blocks.editableParts
import robotran.workshop.blocks.lineOf
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent

/**
 * The keys of the list of blocks. Arrows walk the tree: up and down over lines, right into the parts of a line, left
 * out of it and out of the block around. Enter edits, Space folds, Alt and arrows move blocks, Alt and Enter runs them at
 * once.
 */
internal class BlockKeys(
    private val scope: BlockScope,
    private val clipboard: ClipboardManager,
    private val onProgram: (ProgramEvent) -> Unit,
) {
    private val state get() = scope.state

    /** Whether [event] was a key of the blocks. */
    fun handle(event: KeyEvent): Boolean {
        if (event.type != KeyEventType.KeyDown) return false
        val control = event.isCtrlPressed || event.isMetaPressed
        return when {
            control -> withControl(event)
            event.isAltPressed -> withAlt(event.key)
            event.isShiftPressed -> withShift(event.key)
            else -> alone(event.key)
        }
    }

    private fun alone(key: Key): Boolean {
        val step = STEPS[key]
        when {
            step != null -> send(BlockEvent.Stepped(step))
            key == Key.Enter || key == Key.NumPadEnter -> enter()
            key == Key.Spacebar -> fold()
            key == Key.Delete || key == Key.Backspace -> delete()
            key == Key.Insert -> scope.show(BlockSheet.Palette)
            key == Key.F2 -> state.cursor?.let { scope.show(BlockSheet.Actions(it.block)) }
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
            else -> return false
        }
        return true
    }

    private fun withAlt(key: Key): Boolean {
        when (key) {
            Key.DirectionUp -> send(BlockEvent.Moved(isUp = true))
            Key.DirectionDown -> send(BlockEvent.Moved(isUp = false))
            Key.Enter, Key.NumPadEnter -> state.run?.let { scope.doNow(BlockLoad.Blocks(it)) }
            else -> return false
        }
        return true
    }

    private fun withControl(event: KeyEvent): Boolean {
        when (event.key) {
            Key.Z -> onProgram(if (event.isShiftPressed) ProgramEvent.Redone else ProgramEvent.Undone)
            Key.Y -> onProgram(ProgramEvent.Redone)
            Key.C -> copy()
            Key.X -> if (copy()) delete()
            Key.V -> clipboard.getText()?.text?.takeIf { it.isNotBlank() }?.let { send(BlockEvent.Pasted(it)) }
            Key.D -> state.run?.let { scope.edit(BlockEdit.Duplicate(it)) }
            else -> return false
        }
        return true
    }

    /** Opens the sheet of the part, or of the first part of the line, or what can be done to the block. */
    private fun enter() {
        val cursor = state.cursor ?: return scope.show(BlockSheet.Palette)
        val part = state.part ?: state.program.lineOf(cursor)?.editableParts?.firstOrNull()?.span
        scope.show(part?.let { BlockSheet.Part(it) } ?: BlockSheet.Actions(cursor.block))
    }

    private fun fold() {
        state.cursor?.let { send(BlockEvent.Folded(it.block)) }
    }

    private fun delete() {
        if (state.cursor is BlockCursor.At) scope.edit(BlockEdit.Delete(state.selected.toSet()))
    }

    private fun copy(): Boolean {
        val text = state.run?.let { copied(state.program, it) } ?: return false
        clipboard.setText(AnnotatedString(text))
        return true
    }

    private fun extend(by: Int) {
        val at = (state.cursor as? BlockCursor.At)?.let { state.program.placeOf(it.block) } ?: return
        val siblings = state.program.blocksAt(at.parent, at.slot).orEmpty()
        siblings.getOrNull(at.index + by)?.let { send(BlockEvent.SelectedTo(it.id)) }
    }

    private fun escape(): Boolean {
        if (state.sheet == null && state.refusal == null) return false
        scope.show(null)
        return true
    }

    private fun lineNumber(): Int? = state.cursor?.let { state.program.lineOf(it) }?.let { it.index + 1 }

    private fun send(event: BlockEvent) = scope.onEvent(event)

    private companion object {
        val STEPS = mapOf(
            Key.DirectionUp to BlockStep.UP,
            Key.DirectionDown to BlockStep.DOWN,
            Key.DirectionLeft to BlockStep.LEFT,
            Key.DirectionRight to BlockStep.RIGHT,
            Key.MoveHome to BlockStep.FIRST,
            Key.MoveEnd to BlockStep.LAST,
        )
    }
}
