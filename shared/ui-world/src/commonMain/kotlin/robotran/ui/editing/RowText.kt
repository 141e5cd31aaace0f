package robotran.ui.editing

import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** A heading between rows. */
@Composable
internal fun RowHeading(text: String) = Text(
    text,
    Modifier.padding(top = 12.dp, bottom = 2.dp).heading(),
    TextStyles.body.strong,
)

/** A sentence of help or a placeholder for an empty list. */
@Composable
internal fun HelpText(text: String, modifier: Modifier = Modifier) = Text(
    text,
    modifier.padding(vertical = 6.dp),
    TextStyles.compact,
    color = LocalRobotranColours.current.quiet,
)
