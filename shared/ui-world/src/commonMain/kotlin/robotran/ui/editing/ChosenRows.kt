package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.selectable
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** What is chosen, above its properties. */
@Composable
internal fun ChosenName(text: String, tag: String) = Text(
    text,
    Modifier.testTag(tag).semantics { heading() },
    TextStyles.lead.strong,
)

/** Something in a list, for choosing without seeing or pointing, with a sign if it [isWrong]. */
@Composable
internal fun ChoosingRow(
    text: String,
    tag: String,
    isChosen: Boolean,
    isWrong: Boolean,
    indent: Dp = 0.dp,
    onChoose: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier
            .fillMaxWidth()
            .testTag(tag)
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .focusRing()
            .clip(Shapes.MEDIUM)
            .background(if (isChosen) colours.runningLine else Color.Transparent)
            .selectable(isChosen, role = Role.Button, onClick = onChoose)
            .padding(start = 12.dp + indent, end = 12.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        Text(text, Modifier.weight(1f), TextStyles.body)
        if (isWrong) IconView(EditIcons.WARNING, colours.error, size = 22.dp)
    }
}
