package robotran.ui.brick.nxt

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** A plug with its cable above or below, or an empty socket, and what is written on it. */
@Composable
internal fun Plug(
    colour: Color,
    isAbove: Boolean,
    isPlugged: Boolean,
    unit: Dp,
    modifier: Modifier,
    content: @Composable () -> Unit,
) {
    Box(
        modifier.drawBehind { drawPlug(colour, isAbove, isPlugged, unit.toPx()) },
        contentAlignment = Alignment.Center,
    ) {
        val cable = unit * NxtPlan.CABLE_LENGTH
        Column(
            Modifier.padding(top = if (isAbove) cable else 0.dp, bottom = if (isAbove) 0.dp else cable),
            horizontalAlignment = Alignment.CenterHorizontally,
        ) { content() }
    }
}

/** @param units the font size. */
@Composable
internal fun PlugLabel(text: String, colour: Color, unit: Dp, units: Float) {
    Text(
        text,
        style = TextStyles.scaled(unit, units, units + LEADING).copy(fontWeight = FontWeight.Bold),
        color = colour,
        maxLines = 1,
        softWrap = false,
    )
}

/** Font sizes in units of the [NxtPlan]. */
internal const val PORT_SIZE = 16f
internal const val VALUE_SIZE = 14.5f
private const val LEADING = 2f
