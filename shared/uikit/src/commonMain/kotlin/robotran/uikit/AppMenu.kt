package robotran.uikit

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.rememberScrollState
import androidx.compose.material3.DropdownMenu
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier

/**
 * A drop-down menu. A long menu scrolls and shows a hint that there is more.
 *
 * @param page the current list of several; each starts at its first item.
 */
@Composable
fun AppMenu(
    expanded: Boolean,
    onDismissRequest: () -> Unit,
    modifier: Modifier = Modifier,
    page: Any = Unit,
    content: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    val scroll = key(page) { rememberScrollState() }
    DropdownMenu(
        expanded,
        onDismissRequest,
        modifier.scrollHint(scroll),
        scrollState = scroll,
        containerColor = colours.pane,
    ) { WithAddedFonts { FocusWindow { Column(content = content) } } }
}
