package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onPlaced
import androidx.compose.ui.semantics.focused
import androidx.compose.ui.semantics.semantics
import robotran.robolang.outline.PhrasePart

/** The values that are on the screen, so that one can be carried, or another one put there. */
internal class SocketPlaces {
    private val places = mutableSetOf<SocketPlace>()

    /** The list of blocks; null while it is not on the screen. */
    var list: LayoutCoordinates? = null

    fun add(place: SocketPlace) {
        places += place
    }

    fun remove(place: SocketPlace) {
        places -= place
    }

    /** The values with their places in the list, in pixels. */
    fun all(): List<Pair<PhrasePart.Value, Rect>> {
        val list = list?.takeIf { it.isAttached } ?: return emptyList()
        return places.mapNotNull { place ->
            val part = place.part as? PhrasePart.Value ?: return@mapNotNull null
            val own = place.coordinates?.takeIf { it.isAttached } ?: return@mapNotNull null
            part to list.localBoundingBoxOf(own)
        }
    }

    /** The values at [position] of the list, the innermost first, with their places. */
    fun at(position: Offset): List<Pair<PhrasePart.Value, Rect>> =
        all().filter { (_, place) -> position in place }.sortedBy { (_, place) -> place.area }

    /** The value for which [isRight] holds at [position], the innermost one, or the nearest one within [reach] pixels. */
    fun nearest(position: Offset, reach: Float, isRight: (PhrasePart.Value) -> Boolean): PhrasePart.Value? =
        all().filter { (part, place) -> place.distanceTo(position) <= reach && isRight(part) }
            .minWithOrNull(compareBy({ it.second.distanceTo(position) }, { it.second.area }))?.first
}

private val Rect.area: Float get() = width * height

private fun Rect.distanceTo(position: Offset): Float = Offset(
    position.x - position.x.coerceIn(left, right),
    position.y - position.y.coerceIn(top, bottom),
).getDistance()

/** A socket that is on the screen. Its coordinates stay right while the list scrolls. */
internal class SocketPlace {
    var part: PhrasePart? = null
    var coordinates: LayoutCoordinates? = null
}

/** The carrying of the list around; null outside of it, such as for blocks in a palette. */
internal val LocalBlockDragging = staticCompositionLocalOf<BlockDragging?> { null }

/**
 * Makes [part] known to what carries values, and to a screen reader if the keyboard is at it.
 *
 * @param isAt whether the cursor is at the part.
 */
@Composable
internal fun Modifier.socketPlace(part: PhrasePart, isAt: Boolean): Modifier {
    val dragging = LocalBlockDragging.current ?: return this
    val place = remember { SocketPlace() }
    SideEffect { place.part = part }
    DisposableEffect(dragging) {
        dragging.sockets.add(place)
        onDispose { dragging.sockets.remove(place) }
    }
    val isFocused = isAt && dragging.hasFocus
    return onPlaced { place.coordinates = it }.semantics { if (isFocused) focused = true }
}
