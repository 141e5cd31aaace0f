package robotran.ui.program.blocks

import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.editor.commandFor

/** Ctrl and plus, minus or zero change the size of the text, as in the editor. */
internal fun Modifier.sizeKeys(onCommand: (EditorCommand.Plain) -> Unit): Modifier = onKeyEvent { event ->
    val command = (commandFor(event) as? EditorCommand.Plain)?.takeIf { it in SIZES } ?: return@onKeyEvent false
    if (event.type == KeyEventType.KeyDown) onCommand(command)
    true
}

private val SIZES = setOf(EditorCommand.Plain.LARGER, EditorCommand.Plain.SMALLER, EditorCommand.Plain.DEFAULT_SIZE)
