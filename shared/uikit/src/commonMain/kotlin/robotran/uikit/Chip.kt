package robotran.uikit

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.FilterChip
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp

/** The heading of a group of controls. */
@Composable
fun SectionName(name: String) {
    Text(
        name,
        Modifier.padding(bottom = 4.dp).semantics { heading() },
        color = LocalRobotranColours.current.quiet,
        fontSize = TextSizes.SMALL,
        fontWeight = FontWeight.Medium,
    )
}

/** One of several choices; the selected one has a tick. */
@Composable
fun Chip(name: String, selected: Boolean, tag: String, onClick: () -> Unit) {
    FilterChip(
        selected = selected,
        onClick = onClick,
        label = { Text(name, fontSize = TextSizes.BODY) },
        leadingIcon = if (selected) ({ RunIconView(RunIcon.DONE, side = 16.dp) }) else null,
        modifier = Modifier.testTag(tag).focusRing().defaultMinSize(minHeight = Dimensions.TARGET),
    )
}
