package robotran.uikit

import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp

/** An item of an [AppMenu], with a sign before or behind its words. */
@Composable
fun MenuItem(
    text: String,
    tag: String,
    modifier: Modifier = Modifier,
    leading: (@Composable () -> Unit)? = null,
    trailing: (@Composable () -> Unit)? = null,
    onClick: () -> Unit,
) = MenuItem(tag, onClick, modifier, leading, trailing) {
    Text(text, style = TextStyles.body)
}

/** The same with any content. */
@Composable
fun MenuItem(
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    leading: (@Composable () -> Unit)? = null,
    trailing: (@Composable () -> Unit)? = null,
    content: @Composable () -> Unit,
) = DropdownMenuItem(
    content,
    onClick,
    modifier.testTag(tag).heightIn(min = Dimensions.TARGET),
    leadingIcon = leading,
    trailingIcon = trailing,
)

/** Between groups of items. */
@Composable
fun MenuDivider() = HorizontalDivider(Modifier.padding(vertical = 4.dp))
