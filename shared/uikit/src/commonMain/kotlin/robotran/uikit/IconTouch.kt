package robotran.uikit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp

/**
 * A button with an [icon].
 *
 * @param words the action, for screen readers.
 * @param label a word next to the icon, if there is room.
 */
@Composable
fun IconTouch(
    icon: Icon,
    words: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    label: String? = null,
    colour: Color = LocalRobotranColours.current.onPane,
) {
    Row(
        modifier
            .testTag(tag)
            .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
            .focusRing()
            .clip(RoundedCornerShape(CORNER))
            .clickable(role = Role.Button, onClick = onClick)
            .semantics { contentDescription = words }
            .padding(horizontal = if (label == null) 12.dp else 14.dp),
        Arrangement.spacedBy(8.dp, Alignment.CenterHorizontally),
        Alignment.CenterVertically,
    ) {
        Box(Modifier.size(24.dp)) { Canvas(Modifier.matchParentSize()) { with(icon) { draw(colour) } } }
        if (label != null) {
            Text(label, style = TextStyles.body.medium, color = colour, maxLines = 1)
        }
    }
}

private val CORNER = Corners.MEDIUM
