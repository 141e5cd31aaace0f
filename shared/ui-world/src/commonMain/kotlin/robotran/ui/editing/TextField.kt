package robotran.ui.editing

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
import robotran.editing.Field
import robotran.editing.TextKind
import robotran.editing.WorldEditorTexts
import robotran.uikit.*

/**
 * A line of text, or several.
 *
 * @param refusal why the last edit was refused; null if it was not.
 */
@Composable
internal fun <T : Any> TextField(field: Field.Text<T>, scope: EditScope<T>, refusal: String?) {
    val spec = field.spec
    val isProse = spec.kind == TextKind.PROSE
    var draft by remember(field.tag) { mutableStateOf<String?>(null) }
    val typed = draft
    val title = field.label(spoken)
    val range = if (isProse) WorldEditorTexts::proseRange else WorldEditorTexts::textRange
    val wrong = when {
        typed == null -> null
        !spec.accepts(typed) -> range(spoken, spec.maximum)
        else -> refusal.takeIf { field.isRefused && typed != field.text }
    }
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        Text(title, style = TextStyles.compact)
        CompactField(
            typed ?: field.text,
            FieldWords(title, field.tag, wrong, field.hint?.invoke(spoken).orEmpty()),
            Modifier.fillMaxWidth(),
            if (spec.kind == TextKind.LINE) CompactFieldKind.LINE else CompactFieldKind.TALL,
            onLeft = {
                draft = null
                scope.settle()
            },
        ) { new ->
            val text = if (isProse) new.replace("\r\n", "\n").replace('\t', ' ') else new
            draft = text
            if (spec.accepts(text)) field.with(text)?.let(scope::make)
        }
        if (wrong != null) FieldError(wrong)
    }
}
