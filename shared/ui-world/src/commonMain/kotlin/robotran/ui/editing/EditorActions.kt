package robotran.ui.editing

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** What can be done with what is chosen. */
internal class EditorAction<out T>(val icon: Icon, val label: Label, val tag: String, val edit: T)

/** Buttons for [actions]; [before] is what stands before them. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun <T : Any> EditorActions(
    scope: EditScope<T>,
    actions: List<EditorAction<T>>,
    before: @Composable () -> Unit = {},
) = FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
    before()
    for (action in actions) IconWord(action.icon, action.label(spoken), action.tag, { scope.make(action.edit) })
}
