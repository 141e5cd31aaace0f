package robotran.ui.program

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing

/** One name in a row of names, underlined if it is the one that is [shown]. */
@Composable
internal fun FileTab(title: String, shown: Boolean, tag: String, onChoose: () -> Unit) {
    val colours = LocalRobotranColours.current
    Box(
        Modifier
            .testTag(tag)
            .fillMaxHeight()
            .defaultMinSize(minWidth = Measures.TARGET)
            .focusRing()
            .selectable(shown, role = Role.Tab, onClick = onChoose)
            .drawBehind {
                val margin = 16.dp.toPx()
                val thickness = 3.dp.toPx()
                if (shown) drawRect(colours.onPane, Offset(margin, size.height - thickness), Size(size.width - 2 * margin, thickness))
            }
            .padding(horizontal = 16.dp),
        Alignment.Center,
    ) {
        Text(
            title,
            color = if (shown) colours.onPane else colours.quiet,
            fontSize = 16.sp,
            fontWeight = if (shown) FontWeight.SemiBold else FontWeight.Normal,
            maxLines = 1,
        )
    }
}
