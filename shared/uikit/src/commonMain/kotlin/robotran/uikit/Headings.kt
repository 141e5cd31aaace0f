package robotran.uikit

import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp

/** The heading of a group of controls. */
@Composable
fun SectionName(name: String) = Text(
    name,
    Modifier.padding(bottom = 4.dp).heading(),
    color = LocalRobotranColours.current.quiet,
)
