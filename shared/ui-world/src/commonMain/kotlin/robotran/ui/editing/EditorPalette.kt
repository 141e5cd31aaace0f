package robotran.ui.editing

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
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.uikit.*
import kotlin.math.abs

/**
 * A strip of items. A tap puts one into its usual place; dragging out of the strip puts it anywhere.
 *
 * @param columns the number of columns of a vertical strip; null for a horizontal strip.
 */
@Composable
internal fun EditorPalette(tag: String, columns: Int?, items: List<@Composable () -> Unit>, modifier: Modifier) {
    if (columns == null) {
        Row(
            modifier.testTag(tag).horizontalScroll(rememberScrollState()).padding(4.dp),
            Arrangement.spacedBy(2.dp),
        ) { for (item in items) item() }
    } else {
        Column(
            modifier.testTag(tag).verticalScroll(rememberScrollState()).padding(4.dp),
            Arrangement.spacedBy(2.dp),
        ) {
            for (row in items.chunked(columns)) {
                Row(horizontalArrangement = Arrangement.spacedBy(2.dp)) { for (item in row) item() }
            }
        }
    }
}

/**
 * What an item of a palette looks like.
 *
 * @property lettering how its word is written, if not as it is.
 */
internal class PaletteLook(
    val word: String,
    val tag: String,
    val width: Dp,
    val lettering: SignLettering = SignLettering(word),
    val draw: DrawScope.(Color) -> Unit,
)

/** An item of a palette. [onPut] puts it to a place on the canvas; null is its usual place. */
@Composable
internal fun PaletteButton(look: PaletteLook, view: EditorView, upright: Boolean, onPut: (Offset?) -> Unit) {
    val ink = LocalRobotranColours.current.onPane
    var corner by remember { mutableStateOf(Offset.Zero) }
    val put = rememberUpdatedState(onPut)
    val latest = rememberUpdatedState(look)
    val colour = rememberUpdatedState(ink)
    SignWord(
        look.word,
        look.tag,
        { put.value(null) },
        Modifier
            .width(look.width)
            .onGloballyPositioned { corner = it.positionInRoot() }
            .pointerInput(view) {
                val carry = { at: Offset? ->
                    view.carried = at?.let { CarriedItem(it + corner) { latest.value.draw(this, colour.value) } }
                }
                carryOut(upright, carry) { place ->
                    val inPane = place + corner - view.window.topLeft
                    if (inPane in view.pane) put.value(inPane)
                }
            },
        lettering = look.lettering,
    ) { Canvas(Modifier.size(PALETTE_SIGN)) { look.draw(this, ink) } }
}

/** Widths of a palette grow with the text, but leave room for the canvas. */
@Composable
internal fun stretched(width: Dp): Dp = width * LocalDensity.current.fontScale.coerceIn(1f, MAX_STRETCH)

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

private const val MAX_STRETCH = 1.6f
