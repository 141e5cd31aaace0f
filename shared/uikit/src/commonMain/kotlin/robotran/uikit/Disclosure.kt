package robotran.uikit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.selection.toggleable
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role

/** A line that opens and closes what is below it. */
@Composable
fun Disclosure(label: String, tag: String, isOpen: Boolean, onOpen: (Boolean) -> Unit) = Row(
    Modifier
        .testTag(tag)
        .focusRing()
        .toggleable(isOpen, role = Role.Button, onValueChange = onOpen)
        .defaultMinSize(minHeight = Dimensions.TARGET),
    Arrangement.spacedBy(Space.SMALL),
    Alignment.CenterVertically,
) {
    IconView(if (isOpen) ThinIcons.UP else ThinIcons.DOWN, LocalRobotranColours.current.onPane)
    Text(label, style = TextStyles.body.medium)
}
