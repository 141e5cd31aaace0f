package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.absoluteOffset
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.SheetTransform
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.world.geometry.Point

/**
 * The cross of the explorer for keyboard and screen reader: the arrows move it by five centimetres, with Shift by one.
 * It takes the focus when it comes.
 *
 * @param spot what is at [place], in words.
 * @param onMove receives the new place; null puts the cross away.
 */
@Composable
internal fun ExploringCross(place: Point, spot: String, view: SheetTransform, onMove: (Point?) -> Unit) {
    val now by rememberUpdatedState(place)
    val put by rememberUpdatedState(onMove)
    val focus = remember { FocusRequester() }
    LaunchedEffect(Unit) { focus.requestFocus() }
    val pixels = view.toPixels(place.x, place.y)
    val description = SheetTexts.exploringCross(spoken, spot)
    val moves = EXPLORER_MOVES.map { (words, way) -> words(spoken) to way }

    fun move(way: Point, step: Double): Boolean {
        put(Point(now.x + way.x * step, now.y + way.y * step))
        return true
    }
    Box(
        Modifier
            .absoluteOffset {
                val half = Dimensions.TARGET.toPx() / 2
                IntOffset((pixels.x - half).toInt(), (pixels.y - half).toInt())
            }
            .size(Dimensions.TARGET)
            .testTag(WorldTags.EXPLORING_CROSS)
            .focusRing(Dimensions.TARGET / 2)
            .focusRequester(focus)
            .onKeyEvent { event ->
                val hasModifier = event.isAltPressed || event.isCtrlPressed || event.isMetaPressed
                if (event.type != KeyEventType.KeyDown || hasModifier) return@onKeyEvent false
                val way = EXPLORER_KEYS[event.key]
                when {
                    way != null -> move(way, if (event.isShiftPressed) FINE_STEP else LONG_STEP)
                    event.key == Key.Escape -> true.also { put(null) }
                    else -> false
                }
            }
            .focusable()
            .semantics {
                contentDescription = description
                customActions = moves.map { (words, way) -> CustomAccessibilityAction(words) { move(way, LONG_STEP) } }
            },
    )
}

/** The cross at [place] in this [colour], with a light casing, so that it is seen on any ground. */
internal fun DrawScope.drawExploringCross(place: Point, view: SheetTransform, colour: Color) {
    val middle = view.toPixels(place)
    val arm = ARM.toPx()
    for ((paint, width) in listOf(RobotranColours.CASING to CASING.toPx(), colour to LINE.toPx())) {
        drawLine(paint, middle - Offset(arm, 0f), middle + Offset(arm, 0f), width, StrokeCap.Round)
        drawLine(paint, middle - Offset(0f, arm), middle + Offset(0f, arm), width, StrokeCap.Round)
        drawCircle(paint, arm / 2, middle, style = Stroke(width))
    }
}

private val EXPLORER_KEYS = mapOf(
    Key.DirectionLeft to Point(-1.0, 0.0),
    Key.DirectionRight to Point(1.0, 0.0),
    Key.DirectionUp to Point(0.0, 1.0),
    Key.DirectionDown to Point(0.0, -1.0),
)
private val EXPLORER_MOVES = listOf(
    SheetTexts::moveLeft to Point(-1.0, 0.0),
    SheetTexts::moveRight to Point(1.0, 0.0),
    SheetTexts::moveUp to Point(0.0, 1.0),
    SheetTexts::moveDown to Point(0.0, -1.0),
)

/** In centimetres. */
private const val LONG_STEP = 5.0
private const val FINE_STEP = 1.0
private val ARM = 18.dp
private val CASING = 6.dp
private val LINE = 3.dp
