package robotran.ui.program.blocks

import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.helpWord
import robotran.workshop.blocks.lineOf

/** On F1, as in the text, [onHelp] gets the word that explains the line that the keyboard is at. */
internal fun Modifier.helpKey(blocks: BlocksState, onHelp: (word: String) -> Unit): Modifier = onKeyEvent { event ->
    val line = blocks.cursor?.let(blocks.program::lineOf)
    val word = line?.helpWord(blocks.program.text)
    if (event.key != Key.F1 || word == null) return@onKeyEvent false
    if (event.type == KeyEventType.KeyDown) onHelp(word)
    true
}
