package robotran.ui.robot

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotItem
import robotran.ui.worldedit.CarriedItem
import robotran.ui.worldedit.PALETTE_SIGN
import robotran.uikit.*
import robotran.world.geometry.Point
import kotlin.math.abs

/**
 * The palette of the robot's brick. A tap puts a part into its usual place; dragging out of the strip puts it anywhere.
 *
 * @param upright whether the strip is vertical.
 */
@Composable
internal fun RobotPalette(
    scope: RobotScope,
    view: PlanView,
    upright: Boolean,
    onPut: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val items = RobotItem.of(scope.robot.brick)
    if (upright) {
        Column(
            modifier.testTag("robot-palette").verticalScroll(rememberScrollState()).padding(4.dp),
            Arrangement.spacedBy(2.dp),
        ) { for (item in items) PaletteItem(scope, view, item, upright, onPut) }
    } else {
        Row(
            modifier.testTag("robot-palette").horizontalScroll(rememberScrollState()).padding(4.dp),
            Arrangement.spacedBy(2.dp),
        ) { for (item in items) PaletteItem(scope, view, item, upright, onPut) }
    }
}

@Composable
private fun PaletteItem(scope: RobotScope, view: PlanView, item: RobotItem, upright: Boolean, onPut: () -> Unit) {
    val ink = LocalRobotranColours.current.onPane
    var corner by remember { mutableStateOf(Offset.Zero) }
    val word = itemWord(item)(spoken)
    val width = ITEM_WIDTH * LocalDensity.current.fontScale.coerceIn(1f, MAX_STRETCH)
    val put = rememberUpdatedState { at: Point? ->
        scope.make(RobotEdit.Add(item, at))
        onPut()
    }
    val colour = rememberUpdatedState(ink)
    SignWord(
        word,
        "robot-item-${item.name.lowercase()}",
        { put.value(null) },
        Modifier
            .width(width)
            .onGloballyPositioned { corner = it.positionInRoot() }
            .pointerInput(view) {
                val carry = { at: Offset? ->
                    view.carried = at?.let { CarriedItem(it + corner) { drawRobotItem(item, colour.value) } }
                }
                carryOut(upright, carry) { place ->
                    val inPane = place + corner - view.window.topLeft
                    if (inPane in view.pane) put.value(view.transform.toRobot(inPane))
                }
            },
        lettering = letteringOf(word, width - SIGN_PADDING * 2),
    ) { Canvas(Modifier.size(PALETTE_SIGN)) { drawRobotItem(item, ink) } }
}

@Composable
private fun letteringOf(word: String, width: Dp): SignLettering {
    val measurer = rememberTextMeasurer()
    val style = TextStyles.sign.asWritten()
    val density = LocalDensity.current
    return remember(word, width, style, density, measurer) {
        measurer.signLettering(word, style, with(density) { width.roundToPx() })
    }
}

/** Leaving the strip sideways drags an item; movement along the strip scrolls. */
private suspend fun PointerInputScope.carryOut(upright: Boolean, onCarry: (Offset?) -> Unit, onDrop: (Offset) -> Unit) =
    awaitEachGesture {
        val down = awaitFirstDown(requireUnconsumed = false)
        var carrying = false
        while (true) {
            val change = awaitPointerEvent().changes.firstOrNull { it.id == down.id } ?: break
            if (change.isConsumed && !carrying) break
            val moved = change.position - down.position
            if (!carrying && moved.getDistance() > viewConfiguration.touchSlop) {
                carrying = if (upright) abs(moved.x) > abs(moved.y) else abs(moved.y) > abs(moved.x)
                if (!carrying) break
            }
            if (carrying) {
                change.consume()
                onCarry(change.position.takeIf { change.pressed })
                if (!change.pressed) onDrop(change.position)
            }
            if (!change.pressed) break
        }
        onCarry(null)
    }

private val ITEM_WIDTH = 108.dp
private const val MAX_STRETCH = 1.6f
