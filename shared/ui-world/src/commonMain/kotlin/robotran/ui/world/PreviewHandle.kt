package robotran.ui.world

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.absoluteOffset
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.testTag
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.SheetColours
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.blocks.SheetPreview
import robotran.workshop.blocks.numberFor
import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/**
 * The end of [preview] on the sheet, by which a finger changes the number. Keyboard and screen reader have the number
 * itself for that.
 *
 * @param end where it is, in pixels.
 * @param toCentimetres the point of the paper at a pixel; null for none.
 */
@Composable
internal fun PreviewHandle(
    preview: SheetPreview,
    end: Offset,
    toCentimetres: (Offset) -> Point?,
    onNumber: (Int) -> Unit,
) {
    val now by rememberUpdatedState(preview)
    val place by rememberUpdatedState(toCentimetres)
    val put by rememberUpdatedState(onNumber)
    var coordinates: LayoutCoordinates? by remember { mutableStateOf(null) }
    Box(
        Modifier
            .absoluteOffset {
                val half = Dimensions.TARGET.toPx() / 2
                IntOffset((end.x - half).toInt(), (end.y - half).toInt())
            }
            .size(Dimensions.TARGET)
            .onGloballyPositioned { coordinates = it }
            .testTag(WorldTags.PREVIEW_END)
            .clearAndSetSemantics { testTag = WorldTags.PREVIEW_END }
            .pointerInput(Unit) {
                awaitEachGesture {
                    val down = awaitFirstDown()
                    down.consume()
                    while (true) {
                        val change = awaitPointerEvent().changes.firstOrNull { it.id == down.id } ?: break
                        change.consume()
                        if (!change.pressed) break
                        val at = coordinates?.inParent(change.position) ?: break
                        place(at)?.let { put(numberAt(it, now)) }
                    }
                }
            },
        Alignment.Center,
    ) {
        Box(
            Modifier.size(
                DOT,
            ).background(RobotranColours.CASING, CircleShape).border(3.dp, SheetColours.LABEL, CircleShape),
        )
    }
}

/** The position [local] in the sheet; null once this has left the screen. */
private fun LayoutCoordinates.inParent(local: Offset): Offset? =
    takeIf { it.isAttached }?.parentLayoutCoordinates?.localPositionOf(this, local)

/** The number with which [preview] ends at [point], or in its direction. */
private fun numberAt(point: Point, preview: SheetPreview): Int {
    val x = point.x - preview.pose.x
    val y = point.y - preview.pose.y
    val heading = preview.pose.heading * PI / HALF
    return when (preview) {
        is SheetPreview.Way -> preview.numberFor(x * cos(heading) + y * sin(heading))
        is SheetPreview.Turn -> preview.numberFor((atan2(y, x) - heading) * HALF / PI)
    }
}

private val DOT = 22.dp
private const val HALF = 180.0
