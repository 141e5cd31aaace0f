package robotran.uikit

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.material3.FilterChip
import androidx.compose.material3.FilterChipDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp

/** One of several choices; the selected one has a tick. */
@Composable
fun Chip(name: String, selected: Boolean, tag: String, onClick: () -> Unit) = FilterChip(
    selected,
    onClick,
    { Text(name, style = TextStyles.body) },
    Modifier.testTag(tag).focusRing().defaultMinSize(minHeight = Dimensions.TARGET),
    leadingIcon = if (selected) ({ IconView(RunIcons.DONE, size = 16.dp) }) else null,
)

/**
 * A chip in a dense row that is on or off.
 *
 * @param ground its ground while it is on.
 * @param picture precedes its [name].
 * @param others what its name may become; it has room for the longest.
 */
@Composable
fun SmallChip(
    name: String,
    on: Boolean,
    tag: String,
    ground: Color,
    picture: (@Composable () -> Unit)? = null,
    others: List<String> = emptyList(),
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    FilterChip(
        on,
        onClick,
        { SteadySize(name, others) { Text(it, style = TextStyles.small, maxLines = 1) } },
        Modifier.testTag(tag).focusRing(Corners.SMALL),
        leadingIcon = picture,
        colors = FilterChipDefaults.filterChipColors(
            labelColor = colours.onPane,
            selectedContainerColor = ground,
            selectedLabelColor = colours.onPane,
        ),
    )
}
