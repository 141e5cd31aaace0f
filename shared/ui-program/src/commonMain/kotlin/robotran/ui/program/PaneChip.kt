package robotran.ui.program

import androidx.compose.runtime.Composable
import robotran.ui.code.codeColours
import robotran.uikit.*

/**
 * A chip that is on or off, or one of several choices.
 *
 * @param picture precedes its [words].
 * @param others what its words may become; it has room for the longest.
 */
@Composable
internal fun PaneChip(
    words: String,
    tag: String,
    on: Boolean,
    picture: (@Composable () -> Unit)? = null,
    others: List<String> = emptyList(),
    onClick: () -> Unit,
) {
    SmallChip(words, on, tag, codeColours().partner, picture, others, onClick)
}
