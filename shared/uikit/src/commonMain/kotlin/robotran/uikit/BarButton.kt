package robotran.uikit

import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp

/** What the button of a bar says. */
class BarWords(val word: String, val help: String, val others: List<String> = emptyList())

/**
 * A button of the run bar.
 *
 * @param words the action in one word, and in a sentence for screen readers; the button is wide enough for all words.
 * @param room whether there is room for the word; otherwise only screen readers say it.
 */
@Composable
fun BarButton(
    icon: Icon,
    words: BarWords,
    tag: String,
    modifier: Modifier = Modifier,
    kind: ButtonKind = ButtonKind.RUN_OTHER,
    enabled: Boolean = true,
    room: Boolean = true,
    onClick: () -> Unit,
) = ButtonFrame(
    tag,
    kind,
    modifier.semantics {
        onClick(label = words.help, action = null)
        if (!room) contentDescription = words.word
    },
    enabled,
    if (room) ButtonForm.RUN_BAR.padding else PaddingValues(0.dp),
    onClick = onClick,
) {
    IconView(icon, size = 18.dp)
    if (room) {
        SteadySize(words.word, words.others, Modifier.padding(start = 8.dp), Alignment.CenterStart) {
            Text(it, style = TextStyles.lead.strong, maxLines = 1)
        }
    }
}
