package robotran.ui.drawer

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.theme.LocalRobotranColours

/** Explains how to get content for this tab. */
@Composable
internal fun EmptyDrawer(words: StringResource, modifier: Modifier = Modifier) {
    Box(modifier.padding(24.dp), Alignment.Center) {
        Text(
            stringResource(words),
            Modifier.testTag("drawer-empty"),
            color = LocalRobotranColours.current.quiet,
            fontSize = 16.sp,
            lineHeight = 22.sp,
            textAlign = TextAlign.Center,
        )
    }
}
