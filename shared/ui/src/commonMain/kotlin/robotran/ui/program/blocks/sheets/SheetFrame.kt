package robotran.ui.program.blocks.sheets

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.BackGesture
import robotran.ui.parts.Icon
import robotran.ui.parts.IconTouch
import robotran.ui.program.LocalSheetPlace
import robotran.ui.program.SheetPlace
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_sheet_close
import robotran.ui.theme.LocalRobotranColours

/**
 * A sheet over the blocks.
 *
 * @param scrolls false for a sheet whose content scrolls itself.
 */
@Composable
internal fun SheetFrame(
    title: String,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
    scrolls: Boolean = true,
    content: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    BackGesture(onBack = onClose)
    Surface(
        modifier.testTag("block-sheet").semantics { paneTitle = title },
        RoundedCornerShape(topStart = 20.dp, topEnd = 20.dp),
        color = colours.pane,
        contentColor = colours.onPane,
        shadowElevation = 8.dp,
        border = BorderStroke(1.dp, colours.line),
    ) {
        val scrolling = if (scrolls) Modifier.verticalScroll(rememberScrollState()) else Modifier
        if (LocalSheetPlace.current == SheetPlace.OVER) {
            // The title has no room, but screen readers say that of the pane.
            Row(Modifier.fillMaxWidth()) {
                val inner = scrolling.padding(start = 16.dp, end = 8.dp, top = 8.dp, bottom = 8.dp)
                Column(Modifier.weight(1f).then(inner), Arrangement.spacedBy(8.dp), content = content)
                CloseSheet(onClose)
            }
        } else {
            Column(Modifier.fillMaxWidth()) {
                Row(Modifier.padding(start = 16.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
                    Text(
                        title,
                        Modifier.weight(1f).semantics { heading() },
                        fontSize = 17.sp,
                        fontWeight = FontWeight.Medium,
                        maxLines = 2,
                        overflow = TextOverflow.Ellipsis,
                    )
                    CloseSheet(onClose)
                }
                val inner = Modifier.fillMaxWidth().padding(start = 16.dp, end = 16.dp, bottom = 16.dp)
                Column(
                    Modifier.weight(1f, fill = false).then(scrolling).then(inner),
                    Arrangement.spacedBy(8.dp),
                    content = content,
                )
            }
        }
    }
}

@Composable
private fun CloseSheet(onClose: () -> Unit) =
    IconTouch(Icon.CLOSE, stringResource(Res.string.blocks_sheet_close), "block-sheet-close", onClose)
