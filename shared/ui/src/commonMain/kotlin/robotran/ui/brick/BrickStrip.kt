package robotran.ui.brick

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.state.BrickState
import robotran.ui.theme.RobotranColours
import robotran.ui.theme.Shapes

/** A compact brick for small screens: the digits of its display, and Run. */
@Composable
internal fun BrickStrip(
    state: BrickState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier = Modifier,
) {
    Row(
        modifier.background(RobotranColours.YELLOW, Shapes.LARGE).padding(8.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        LcdNumbers(state.glass, Modifier.size(134.dp, 58.dp))
        BrickButtonView(
            BrickButton.RUN,
            1.dp,
            BrickButton.RUN in down,
            { onPress(BrickButton.RUN) },
            { onRelease(BrickButton.RUN) },
            Modifier.size(64.dp, 52.dp),
        )
    }
}
