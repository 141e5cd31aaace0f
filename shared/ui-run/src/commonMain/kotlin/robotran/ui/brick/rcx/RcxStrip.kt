package robotran.ui.brick.rcx

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.rcxrom.state.RcxState
import robotran.uikit.*

/**
 * A compact RCX where room is scarce: the digits of its display, and Run.
 *
 * @param isLow whether it is as low as a finger allows.
 */
@Composable
internal fun RcxStrip(
    state: RcxState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier,
    isLow: Boolean,
) {
    Row(
        modifier.background(RobotranColours.YELLOW, Shapes.LARGE).padding(if (isLow) 4.dp else 8.dp),
        horizontalArrangement = Arrangement.spacedBy(if (isLow) 8.dp else 12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        LcdNumbers(state.glass, if (isLow) Modifier.size(110.dp, 48.dp) else Modifier.size(134.dp, 58.dp))
        BrickButtonView(
            BrickButton.RUN,
            1.dp,
            BrickButton.RUN in down,
            { onPress(BrickButton.RUN) },
            { onRelease(BrickButton.RUN) },
            if (isLow) Modifier.size(60.dp, 48.dp) else Modifier.size(64.dp, 52.dp),
        )
    }
}
