package robotran.ui.program

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.combinedClickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/**
 * A tab in a row, underlined if it is [shown].
 *
 * @param onRename called on a long press or double click to rename it; null if it cannot be renamed.
 */
@OptIn(ExperimentalFoundationApi::class)
@Composable
internal fun FileTab(title: String, shown: Boolean, tag: String, onChoose: () -> Unit, onRename: (() -> Unit)? = null) {
    val rename = EditorTexts.rename(spoken)
    val colours = LocalRobotranColours.current
    Box(
        Modifier
            .testTag(tag)
            .fillMaxHeight()
            .defaultMinSize(minWidth = Dimensions.TARGET)
            .focusRing()
            .combinedClickable(
                role = Role.Tab,
                onLongClickLabel = rename.takeIf { onRename != null },
                onLongClick = onRename,
                onDoubleClick = onRename,
                onClick = onChoose,
            )
            .semantics { selected = shown }
            .drawBehind {
                val margin = 16.dp.toPx()
                val thickness = 3.dp.toPx()
                if (shown) {
                    drawRect(
                        colours.onPane,
                        Offset(margin, size.height - thickness),
                        Size(size.width - 2 * margin, thickness),
                    )
                }
            }
            .padding(horizontal = 16.dp),
        Alignment.Center,
    ) {
        Text(
            title,
            style = TextStyles.body.strongIf(shown),
            color = if (shown) colours.onPane else colours.quiet,
            maxLines = 1,
        )
    }
}
