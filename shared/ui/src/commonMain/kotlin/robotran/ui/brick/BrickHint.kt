package robotran.ui.brick

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.rom.BrickState
import robotran.ui.resources.Res
import robotran.ui.resources.brick_off
import robotran.ui.theme.LocalRobotranColours

/** What the brick cannot say itself, and which button helps; nothing if all can be seen on it. */
@Composable
internal fun BrickHint(state: BrickState, modifier: Modifier = Modifier) {
    val words = state.explanation ?: if (state.poweredOn) return else stringResource(Res.string.brick_off)
    val colours = LocalRobotranColours.current
    Text(
        words,
        modifier
            .fillMaxWidth()
            .background(colours.pane, RoundedCornerShape(12.dp))
            .padding(12.dp)
            .testTag("brick-hint")
            .semantics { liveRegion = LiveRegionMode.Polite },
        color = colours.onPane,
        fontSize = 16.sp,
        lineHeight = 22.sp,
    )
}
