package robotran.ui.editing

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.dp
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import kotlin.math.roundToInt

/**
 * An item dragged from a palette.
 *
 * @property at its position, in pixels of the screen.
 * @property sign draws it as in the palette.
 */
internal class CarriedItem(val at: Offset, val sign: DrawScope.() -> Unit)

/** [item] under the finger, in a pane whose upper left corner is at [corner]. */
@Composable
internal fun CarriedSign(item: CarriedItem, corner: Offset) {
    val colours = LocalRobotranColours.current
    val radius = with(LocalDensity.current) { CARRIED.toPx() / 2 }
    val place = item.at - corner
    Box(
        Modifier
            .offset { IntOffset((place.x - radius).roundToInt(), (place.y - radius).roundToInt()) }
            .size(CARRIED)
            .testTag(WorldTags.CARRIED)
            .background(colours.pane.copy(alpha = 0.9f), CircleShape)
            .border(2.dp, colours.focus, CircleShape),
        Alignment.Center,
    ) { Canvas(Modifier.size(PALETTE_SIGN)) { item.sign(this) } }
}

/** The size of the signs in palettes. */
internal val PALETTE_SIGN = 28.dp
private val CARRIED = 52.dp
