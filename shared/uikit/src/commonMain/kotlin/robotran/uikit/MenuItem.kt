package robotran.uikit

import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp

/** A menu item large enough for a finger. */
@Composable
fun MenuItem(text: String, tag: String, onClick: () -> Unit) = DropdownMenuItem(
    text = { Text(text, color = LocalRobotranColours.current.onPane, fontSize = TextSizes.BODY) },
    onClick = onClick,
    modifier = Modifier.testTag(tag).heightIn(min = Dimensions.TARGET),
)

@Composable
fun MenuDivider() = HorizontalDivider(Modifier.padding(vertical = 4.dp), color = LocalRobotranColours.current.line)
