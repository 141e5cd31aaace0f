package robotran.ui.parts

import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes

/** A menu item large enough for a finger. */
@Composable
internal fun MenuItem(text: String, tag: String, onClick: () -> Unit) = DropdownMenuItem(
    text = { Text(text, color = LocalRobotranColours.current.onPane, fontSize = TextSizes.BODY) },
    onClick = onClick,
    modifier = Modifier.testTag(tag).heightIn(min = Dimensions.TARGET),
)

@Composable
internal fun MenuDivider() =
    HorizontalDivider(Modifier.padding(vertical = 4.dp), color = LocalRobotranColours.current.line)
