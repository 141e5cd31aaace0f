package robotran.ui.program.blocks

import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.text.AnnotatedString
import robotran.blockediting.copied
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockRow
import robotran.workshop.event.BlockEvent

/**
 * What a touch on a row does: it puts the cursor there, or selects all blocks up to it.
 *
 * @param extends whether Shift is held.
 */
internal fun BlockScope.touched(row: BlockRow, extends: Boolean) {
    val isBlock = row is BlockRow.First
    onEvent(
        if (isBlock && (extends || state.isChoosing)) {
            BlockEvent.SelectedTo(row.block.id)
        } else {
            BlockEvent.CursorPut(row.cursor ?: BlockCursor.At(row.block.id))
        },
    )
}

/** Copies the value with the cursor, or the selected blocks, as text; false if there is nothing. */
internal fun ClipboardManager.copy(scope: BlockScope): Boolean {
    val state = scope.state
    val value = state.part?.let { scope.textOf(it) }
    val text = value ?: state.run?.let { copied(state.program, it) } ?: return false
    setText(AnnotatedString(text))
    return true
}

/** Adds the blocks of [text], which was copied. */
internal fun BlockScope.paste(text: String) {
    if (text.isNotBlank()) onEvent(BlockEvent.Pasted(text))
}
