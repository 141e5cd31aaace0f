package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp

/**
 * A round button at the edge of the sheet.
 *
 * @param label the accessibility text of its [icon].
 * @param on whether it is switched on; null if it is not a switch.
 */
@Composable
fun SheetButton(
    icon: Icon,
    label: String,
    tag: String,
    on: Boolean? = null,
    enabled: Boolean = true,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    val press = if (on == null) {
        Modifier.clickable(enabled, role = Role.Button, onClick = onClick)
    } else {
        Modifier.toggleable(on, enabled, Role.Switch) { onClick() }
    }
    Box(
        Modifier
            .testTag(tag)
            .size(Dimensions.TARGET)
            .focusRing(Dimensions.TARGET / 2)
            .clip(CircleShape)
            .background(if (on == true) colours.onPane else colours.pane)
            .border(1.dp, colours.line, CircleShape)
            .then(press)
            .semantics { contentDescription = label },
        Alignment.Center,
    ) {
        val colour = when {
            !enabled -> colours.line
            on == true -> colours.pane
            else -> colours.onPane
        }
        Canvas(Modifier.size(24.dp)) { with(icon) { draw(colour) } }
    }
}
