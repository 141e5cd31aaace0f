package robotran.ui.editing

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.editing.ChoiceLook
import robotran.editing.Field
import robotran.uikit.*

/**
 * Draws [fields]. What their changes make is sent to [scope].
 *
 * @param refusal why the last edit was refused; null if it was not.
 */
@Composable
internal fun <T : Any> Form(fields: List<Field<T>>, scope: EditScope<T>, refusal: String? = null) {
    for (field in fields) key(field.tag) { FormRow(field, scope, refusal) }
}

@Composable
private fun <T : Any> FormRow(field: Field<T>, scope: EditScope<T>, refusal: String?) {
    when (field) {
        is Field.Heading -> RowHeading(field.label(spoken))
        is Field.Help -> HelpText(field.label(spoken))
        is Field.Wrong -> FieldError(field.label(spoken))
        is Field.Flag -> FlagField(field, scope)
        is Field.Number -> NumberField(field, scope)

        is Field.OptionalNumber -> {
            FlagField(field.switch, scope)
            field.number?.let { NumberField(it, scope) }
        }

        is Field.Text -> TextField(field, scope, refusal)
        is Field.Choice<*, T> -> ChoiceField(field, scope)
        is Field.Group -> Column(Modifier.fillMaxWidth()) { Form(field.fields, scope, refusal) }
        is Field.OneOf -> OneOfField(field, scope)
        is Field.Buttons -> Buttons(field, scope)
    }
}

@Composable
private fun <T : Any> FlagField(field: Field.Flag<T>, scope: EditScope<T>) =
    SwitchRow(field.label(spoken), field.isOn, field.tag) { on -> field.with(on)?.let(scope::makeAtOnce) }

@Composable
private fun <V, T : Any> ChoiceField(field: Field.Choice<V, T>, scope: EditScope<T>) {
    val language = LocalLanguage.current
    val title = field.label(spoken)
    val choices = field.options.map { it.value to it.label(spoken) }
    val choose = { value: V -> field.with(value, language)?.let(scope::makeAtOnce) ?: Unit }
    when (field.look) {
        ChoiceLook.CHIPS -> ChipRow(title, choices, field.chosen, field.tag, choose)
        ChoiceLook.MENU -> MenuRow(title, choices, field.shown(spoken), field.tag, choose)
        ChoiceLook.SWATCHES -> Swatches(title, choices, field.chosen, field.tag, choose)
    }
}

@Composable
private fun <T : Any> OneOfField(field: Field.OneOf<T>, scope: EditScope<T>) {
    var chosen by remember { mutableIntStateOf(0) }
    val number = chosen.coerceIn(field.names.indices)
    Column(Modifier.fillMaxWidth()) {
        val choices = field.names.mapIndexed { one, name -> one to name(spoken) }
        MenuRow(field.label(spoken), choices, choices[number].second, field.tag) { chosen = it }
        Form(field.fields(number), scope)
    }
}

/** A single one stands by itself, so it has more room above it. */
@Composable
private fun <T : Any> Buttons(field: Field.Buttons<T>, scope: EditScope<T>) {
    val only = field.buttons.singleOrNull()
    if (only != null) {
        Button(only.label(spoken), only.tag, ButtonKind.EDITOR, Modifier.padding(top = 8.dp)) { scope.make(only.value) }
    } else {
        Row(Modifier.padding(top = 4.dp), Arrangement.spacedBy(8.dp)) {
            for (button in field.buttons) {
                Button(button.label(spoken), button.tag, ButtonKind.EDITOR, Modifier.weight(1f)) {
                    scope.make(button.value)
                }
            }
        }
    }
}
