package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** A tab of an editor's panel. */
internal interface EditorTab {
    val tag: String
    val title: Label
}

/** @param open null if none is open. */
@Composable
internal fun <P : EditorTab> EditorTabs(tabs: List<P>, open: P?, minWidth: Dp, onChoose: (P) -> Unit) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Row(
        Modifier
            .fillMaxWidth()
            .background(colours.pane)
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .selectableGroup(),
        Arrangement.spacedBy(4.dp),
    ) {
        for (tab in tabs) {
            val isOpen = tab == open
            Column(
                Modifier
                    .testTag(tab.tag)
                    .defaultMinSize(minWidth, Dimensions.TARGET)
                    .broughtIntoSight(isOpen)
                    .focusRing()
                    .selectable(isOpen, role = Role.Tab) { onChoose(tab) }
                    .width(IntrinsicSize.Max)
                    .padding(horizontal = 12.dp),
                Arrangement.Center,
                Alignment.CenterHorizontally,
            ) {
                Text(
                    tab.title(spoken),
                    Modifier.padding(top = 12.dp, bottom = 8.dp),
                    TextStyles.compact.strong,
                    color = if (isOpen) colours.onPane else colours.quiet,
                    maxLines = 1,
                )
                Box(Modifier.fillMaxWidth().height(3.dp).background(if (isOpen) colours.onPane else Color.Transparent))
            }
        }
    }
    HorizontalDivider()
}
