package robotran.uikit

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.IconButton
import androidx.compose.material3.IconButtonDefaults
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp

/**
 * A secondary button of the run bar.
 *
 * @param word the action in one word; without [room] it is only read by screen readers.
 * @param otherWords other labels at other times; the button is wide enough for all.
 * @param help the action in a sentence, for screen readers.
 */
@Composable
fun BarButton(
    icon: RunIcon,
    word: String,
    help: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    enabled: Boolean = true,
    room: Boolean = true,
    otherWords: List<String> = emptyList(),
) {
    val colours = LocalRobotranColours.current
    OutlinedButton(
        onClick = onClick,
        enabled = enabled,
        modifier = modifier
            .testTag(tag)
            .semantics {
                onClick(label = help, action = null)
                if (!room) contentDescription = word
            }
            .focusRing(BAR_CORNER)
            .defaultMinSize(minWidth = if (room) 0.dp else BAR_HEIGHT, minHeight = BAR_HEIGHT),
        shape = RoundedCornerShape(BAR_CORNER),
        colors = ButtonDefaults.outlinedButtonColors(
            contentColor = colours.onPane,
            disabledContentColor = colours.quiet.copy(alpha = 0.6f),
        ),
        border = BorderStroke(if (enabled) 2.dp else 1.dp, if (enabled) colours.onPane else colours.line),
        contentPadding = if (room) BAR_PADDING else PaddingValues(0.dp),
    ) {
        RunIconView(icon, side = 18.dp)
        if (room) {
            SteadySize(word, otherWords, Modifier.padding(start = 8.dp), Alignment.CenterStart) {
                Text(it, fontSize = TextSizes.LEAD, fontWeight = FontWeight.SemiBold, maxLines = 1)
            }
        }
    }
}

/** An icon button without a frame; [name] is its accessibility text. */
@Composable
fun RunIconButton(
    icon: RunIcon,
    name: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    enabled: Boolean = true,
) {
    val colours = LocalRobotranColours.current
    IconButton(
        onClick = onClick,
        enabled = enabled,
        modifier = modifier.testTag(tag).semantics { contentDescription = name }.focusRing().size(Dimensions.TARGET),
        colors = IconButtonDefaults.iconButtonColors(
            contentColor = colours.onPane,
            disabledContentColor = colours.quiet.copy(alpha = 0.5f),
        ),
    ) {
        RunIconView(icon)
    }
}

val BAR_CORNER = Corners.LARGE
val BAR_HEIGHT = 56.dp
val BAR_PADDING = PaddingValues(horizontal = 16.dp)
