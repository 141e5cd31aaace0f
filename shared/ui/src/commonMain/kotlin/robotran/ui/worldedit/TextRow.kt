package robotran.ui.worldedit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.worldedit_text_range
import robotran.ui.theme.LocalRobotranColours
import robotran.worldediting.isText

/**
 * A line of text, or several if it is [tall].
 *
 * @param maximum its most characters.
 * @param onChange is given only what can be taken.
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
    hint: String = "",
    refusal: String? = null,
) {
    var draft by remember(tag) { mutableStateOf<String?>(null) }
    val typed = draft
    val isWrong = typed != null && !tall && !isText(typed, maximum, mayBeBlank)
    val wrong = if (isWrong) stringResource(Res.string.worldedit_text_range, maximum) else refusal.takeIf { typed != null && typed != text }
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        Text(title, color = LocalRobotranColours.current.onPane, fontSize = 15.sp)
        EditFieldBox(wrong != null, Modifier.fillMaxWidth()) {
            EditField(
                text = typed ?: text,
                label = title,
                tag = tag,
                wrong = wrong,
                onText = {
                    draft = it
                    if (tall || isText(it, maximum, mayBeBlank)) onChange(it)
                },
                onLeft = {
                    draft = null
                    onSettle()
                },
                tall = tall,
                hint = hint,
            )
        }
        if (wrong != null) Wrong(wrong)
    }
}
