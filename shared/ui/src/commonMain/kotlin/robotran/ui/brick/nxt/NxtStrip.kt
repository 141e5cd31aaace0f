package robotran.ui.brick.nxt

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.nxt.display.DisplaySize
import robotran.nxt.state.NxtState
import robotran.ui.theme.Shapes

/**
 * A compact NXT where room is scarce: four rows of its display, and ENTER.
 *
 * @param isLow whether it is as low as a finger allows.
 */
@Composable
internal fun NxtStrip(
    state: NxtState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier,
    isLow: Boolean,
) {
    Row(
        modifier
            .background(NxtColours.FACE, Shapes.LARGE)
            .border(1.dp, NxtColours.EDGE, Shapes.LARGE)
            .padding(if (isLow) 4.dp else 8.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        NxtDisplayView(
            state,
            2.dp,
            (if (isLow) Modifier.size(118.dp, 48.dp) else Modifier.size(178.dp, 58.dp))
                .background(NxtColours.FRAME, Shapes.SMALL)
                .padding(1.dp),
            rowsToShow(state),
        )
        NxtButtonView(
            BrickButton.ENTER,
            1.dp,
            BrickButton.ENTER in down,
            { onPress(BrickButton.ENTER) },
            { onRelease(BrickButton.ENTER) },
            if (isLow) Modifier.size(52.dp, 48.dp) else Modifier.size(56.dp, 52.dp),
        )
    }
}

/** The rows around the marked entry of a menu; otherwise those with the last ones of what is shown. */
internal fun rowsToShow(state: NxtState): IntRange {
    val lines = state.display.lines
    val first = lines.indexOfFirst { it.isNotBlank() }.coerceAtLeast(0)
    val last = lines.indexOfLast { it.isNotBlank() }.coerceAtLeast(0)
    val marked = state.menu?.takeIf { it.selected >= 0 }?.let { menu ->
        lines.indexOfFirst { it.trim() == menu.entries[menu.selected].take(DisplaySize.COLUMNS).trim() }
    }
    val top = when {
        marked != null && marked >= 0 -> marked - STRIP_ROWS / 2
        last - first < STRIP_ROWS -> first
        else -> last - STRIP_ROWS + 1
    }
    return top.coerceIn(0, DisplaySize.ROWS - STRIP_ROWS).let { it..<it + STRIP_ROWS }
}

private const val STRIP_ROWS = 4
