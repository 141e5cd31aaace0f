package robotran.uikit

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp

/**
 * A dialog over the workshop: its title, [content], [notice] in sight below it, and buttons at the bottom. Escape and a
 * touch outside close it.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun DialogFrame(
    title: String,
    onClose: () -> Unit,
    buttons: @Composable () -> Unit,
    notice: (@Composable () -> Unit)? = null,
    content: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    AppDialog(onDismissRequest = onClose) {
        Surface(
            Modifier.widthIn(max = 520.dp).testTag("document-dialog").semantics { paneTitle = title },
            Shapes.SHEET,
        ) {
            Column(Modifier.padding(24.dp), Arrangement.spacedBy(16.dp)) {
                Text(
                    title,
                    Modifier.semantics {
                        heading()
                    },
                    TextStyles.dialogTitle,
                )
                Column(
                    Modifier.weight(1f, fill = false).verticalScroll(rememberScrollState()),
                    Arrangement.spacedBy(12.dp),
                    content = content,
                )
                notice?.invoke()
                FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) { buttons() }
            }
        }
    }
}

/** An explanatory sentence. */
@Composable
fun Explanation(label: String, modifier: Modifier = Modifier, bad: Boolean = false) {
    val colours = LocalRobotranColours.current
    Text(label, modifier, TextStyles.label, color = if (bad) colours.error else colours.onPane)
}
