package robotran.ui.worldedit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.worldediting.isValidText

/**
 * A line of text, or several if it is [tall] or [isProse].
 *
 * @param tall whether it may be any text, such as a program; [error] is its error.
 * @param maximum the max number of characters.
 * @param onChange receives valid values only.
 */
@Composable
internal fun TextRow(
    title: String,
    text: String,
    maximum: Int,
    tag: String,
    onChange: (String) -> Unit,
    onSettle: () -> Unit,
    mayBeBlank: Boolean = false,
    tall: Boolean = false,
    isProse: Boolean = false,
    hint: String = "",
    error: String? = null,
) {
    var draft by remember(tag) { mutableStateOf<String?>(null) }
    val typed = draft
    val range = if (isProse) WorldEditorTexts::proseRange else WorldEditorTexts::textRange
    val isWrong = typed != null && !tall && !isValidText(typed, maximum, mayBeBlank, isProse)
    val wrong = if (isWrong) range(spoken, maximum) else error.takeIf { typed != null && typed != text }
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        Text(title, style = TextStyles.compact)
        EditFieldBox(wrong != null, Modifier.fillMaxWidth()) {
            EditField(
                text = typed ?: text,
                label = title,
                tag = tag,
                wrong = wrong,
                onText = { new ->
                    val text = if (isProse) new.replace("\r\n", "\n").replace('\t', ' ') else new
                    draft = text
                    if (tall || isValidText(text, maximum, mayBeBlank, isProse)) onChange(text)
                },
                onLeft = {
                    draft = null
                    onSettle()
                },
                tall = tall || isProse,
                hint = hint,
            )
        }
        if (wrong != null) Wrong(wrong)
    }
}
