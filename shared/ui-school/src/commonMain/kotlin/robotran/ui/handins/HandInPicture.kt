package robotran.ui.handins

import androidx.compose.foundation.Image
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.layout.ContentScale
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.simulation.state.SessionState
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.renderSheet
import robotran.uikit.*
import robotran.world.World
import kotlin.math.sqrt

/**
 * The sheet at the end of the first run of [graded]; an empty place before it is graded. The words beside it say what
 * it shows, so it needs no accessibility text.
 */
@Composable
internal fun HandInPicture(graded: GradedHandIn.Graded?, plan: GradingPlan, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    BoxWithConstraints(modifier.background(colours.desk, Shapes.PIECE).padding(Space.HAIR), Alignment.Center) {
        if (graded == null) return@BoxWithConstraints
        val room = PictureBounds.of(constraints.maxWidth, constraints.maxHeight, LocalDensity.current.density)
        val key = PictureKey(graded.picture, sheetColours, room)
        val picture by produceState(pictures.ready(key), key) {
            value = pictures.ready(key) ?: drawn(plan.worlds.first().world, key).also { pictures.keep(key, it) }
        }
        picture?.let { Image(it, contentDescription = null, Modifier.fillMaxSize(), contentScale = ContentScale.Fit) }
    }
}

/**
 * The size of a picture in the table, where many rows are to be in sight: as wide as the sheet of [plan] asks, so that
 * nothing of it stays empty, and of the same area for all but very long sheets.
 */
internal fun rowPictureSize(plan: GradingPlan): DpSize = pictureSize(plan, ROW_AREA, 48.dp..ROW_WIDTH, ROW_HEIGHT)

/** The same on a card. */
internal fun cardPictureSize(plan: GradingPlan): DpSize = pictureSize(plan, CARD_AREA, 56.dp..CARD_WIDTH, CARD_WIDTH)

private fun pictureSize(plan: GradingPlan, area: Float, widths: ClosedRange<Dp>, maxHeight: Dp): DpSize {
    val aspect = aspectOf(plan)
    val width = sqrt(area * aspect).dp.coerceIn(widths)
    return DpSize(width, (width / aspect).coerceAtMost(maxHeight))
}

/** Width divided by height of the sheet. */
internal fun aspectOf(plan: GradingPlan): Float = plan.worlds.first().world.paper.let { it.width / it.height }.toFloat()

private suspend fun drawn(world: World, key: PictureKey): ImageBitmap {
    // Rows that come into sight together are drawn one after the other.
    yield()
    val width = key.room.widthFor(world.paper)
    return withContext(Dispatchers.Default) {
        renderSheet(world, key.state, width, colours = key.colours, density = key.room.density)
    }
}

/** Two pictures are the same if they are of the same state, which is too large to compare. */
private class PictureKey(val state: SessionState, val colours: SheetColours, val room: PictureBounds) {
    override fun equals(other: Any?): Boolean = other is PictureKey && state === other.state &&
        colours == other.colours && room == other.room

    override fun hashCode(): Int = room.hashCode()
}

/**
 * The pictures that were drawn last. A list is never changed, since windows and tests may look on threads of their own.
 */
private class KeptPictures {
    private var kept = listOf<Pair<PictureKey, ImageBitmap>>()

    fun ready(key: PictureKey): ImageBitmap? = kept.firstOrNull { it.first == key }?.second

    fun keep(key: PictureKey, picture: ImageBitmap) {
        kept = (kept + (key to picture)).takeLast(MAX)
    }

    private companion object {
        /** Several classes of small ones. */
        const val MAX = 120
    }
}

private val pictures = KeptPictures()

/** In dp by dp. */
private const val ROW_AREA = 3_600f
private val ROW_WIDTH = 128.dp
private val ROW_HEIGHT = 64.dp
private const val CARD_AREA = 6_400f
private val CARD_WIDTH = 110.dp
