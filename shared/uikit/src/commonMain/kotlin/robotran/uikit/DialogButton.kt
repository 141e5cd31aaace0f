package robotran.uikit

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.TextUnit
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

/**
 * A button of a sheet.
 *
 * @param spoken what a screen reader says, if that differs from [label].
 * @param isChosen whether it is what the program has now.
 * @param sign is drawn instead of [label].
 */
@Composable
fun DialogButton(
    label: String,
    tag: String,
    modifier: Modifier = Modifier,
    spoken: String = label,
    isChosen: Boolean = false,
    sign: Icon? = null,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    val shape = Shapes.MEDIUM
    Box(
        modifier
            .testTag(tag)
            .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
            .focusRing()
            .clip(shape)
            .background(if (isChosen) colours.onPane else colours.pane)
            .border(1.dp, colours.quiet, shape)
            .clickable(role = Role.Button, onClick = onClick)
            .semantics {
                contentDescription = spoken
                selected = isChosen
            }
            .padding(horizontal = if (label.length == 1) 4.dp else 14.dp, vertical = 8.dp),
        Alignment.Center,
    ) {
        if (sign == null) {
            Text(
                label,
                style = (if (label.length == 1) TextStyle(fontSize = signSize()) else TextStyles.body).medium,
                color = if (isChosen) colours.pane else colours.onPane,
                textAlign = TextAlign.Center,
            )
        } else {
            IconView(sign, if (isChosen) colours.pane else colours.onPane, size = SIGN)
        }
    }
}

/** A single sign is large anyway; with the largest text it still fits on its key. */
@Composable
private fun signSize(): TextUnit = (19 * minOf(1f, MOST_SCALE / LocalDensity.current.fontScale)).sp

/** A heading between the rows of a sheet. */
@Composable
fun DialogHeading(label: String) = Text(
    label,
    Modifier.padding(top = 8.dp).heading(),
    TextStyles.compact.strong,
    color = LocalRobotranColours.current.quiet,
)

private const val MOST_SCALE = 1.4f

private val SIGN = 20.dp
