package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.absoluteOffset
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
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
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.SheetTransform
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.MeasuringEnd
import robotran.workshop.measuring.SnappedPlace
import robotran.workshop.measuring.after
import robotran.world.geometry.Point

/**
 * The ends of ruler and protractor for keyboard and screen reader: the arrows move one by a centimetre, with Shift by a
 * millimetre, Enter puts it onto the next thing, Escape takes both away. What is measured is announced.
 *
 * @param onChange receives the changed measuring; null takes it away.
 */
@Composable
internal fun MeasuringHandles(
    measuring: Measuring,
    things: List<SnappedPlace>,
    view: SheetTransform,
    onChange: (Measuring?) -> Unit,
) {
    val words = measuringWords(measuring)
    Box(
        Modifier.size(1.dp).testTag(WorldTags.MEASURED).semantics {
            liveRegion = LiveRegionMode.Polite
            contentDescription = words
        },
    )
    for (end in MeasuringEnd.entries) key(end) { MeasuringHandle(end, measuring, things, view, onChange) }
}

@Composable
private fun MeasuringHandle(
    end: MeasuringEnd,
    measuring: Measuring,
    things: List<SnappedPlace>,
    view: SheetTransform,
    onChange: (Measuring?) -> Unit,
) {
    val now by rememberUpdatedState(measuring)
    val places by rememberUpdatedState(things)
    val put by rememberUpdatedState(onChange)
    val pixels = view.toPixels(measuring.placeOf(end))
    val description = describeEnd(end, measuring, things)

    fun move(x: Double, y: Double): Boolean {
        val place = now.placeOf(end)
        put(now.moved(end, SnappedPlace(Point(place.x + x, place.y + y))))
        return true
    }

    fun goToNext(): Boolean {
        put(now.moved(end, places.after(now.placeOf(end)) ?: return false))
        return true
    }
    val next = SheetTexts.measureNext(spoken)
    val moves = MOVES.map { (words, step) -> words(spoken) to step }
    Box(
        Modifier
            .absoluteOffset {
                val half = Dimensions.TARGET.toPx() / 2
                IntOffset((pixels.x - half).toInt(), (pixels.y - half).toInt())
            }
            .size(Dimensions.TARGET)
            .testTag(WorldTags.measure(end))
            .focusRing(Dimensions.TARGET / 2)
            .onKeyEvent { event ->
                if (event.type != KeyEventType.KeyDown || event.hasModifier) return@onKeyEvent false
                val step = if (event.isShiftPressed) FINE_STEP else STEP
                val way = WAYS[event.key]
                when {
                    way != null -> move(way.x * step, way.y * step)
                    event.key in ENTER -> goToNext()
                    event.key == Key.Escape -> true.also { put(null) }
                    else -> false
                }
            }
            .focusable()
            .semantics {
                contentDescription = description
                onClick(next) { goToNext() }
                customActions = moves.map { (words, step) ->
                    CustomAccessibilityAction(words) { move(step.x, step.y) }
                }
            },
    )
}

private val KeyEvent.hasModifier: Boolean get() = isAltPressed || isCtrlPressed || isMetaPressed

private val WAYS = mapOf(
    Key.DirectionLeft to Point(-1.0, 0.0),
    Key.DirectionRight to Point(1.0, 0.0),
    Key.DirectionUp to Point(0.0, 1.0),
    Key.DirectionDown to Point(0.0, -1.0),
)
private val ENTER = setOf(Key.Enter, Key.NumPadEnter, Key.Spacebar)

/** In centimetres. */
private const val FINE_STEP = 0.1
private val MOVES = listOf(
    SheetTexts::moveLeft to Point(-STEP, 0.0),
    SheetTexts::moveRight to Point(STEP, 0.0),
    SheetTexts::moveUp to Point(0.0, STEP),
    SheetTexts::moveDown to Point(0.0, -STEP),
)
