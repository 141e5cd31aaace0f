package robotran.uikit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.lazy.grid.GridCells
import androidx.compose.foundation.lazy.grid.GridItemSpan
import androidx.compose.foundation.lazy.grid.LazyGridItemScope
import androidx.compose.foundation.lazy.grid.LazyGridScope
import androidx.compose.foundation.lazy.grid.LazyGridState
import androidx.compose.foundation.lazy.grid.LazyVerticalGrid
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * Cards in columns, which scroll.
 *
 * @param gap between cards.
 * @param padding around all of them.
 */
@Composable
fun CardGrid(
    columns: GridCells,
    state: LazyGridState,
    tag: String,
    gap: Dp = Space.LARGE,
    padding: Dp = Space.PAGE,
    content: LazyGridScope.() -> Unit,
) = LazyVerticalGrid(
    columns,
    Modifier.fillMaxSize().testTag(tag).scrolledByReaders(state) { state.layoutInfo.viewportSize.height },
    state,
    PaddingValues(padding),
    horizontalArrangement = Arrangement.spacedBy(gap),
    verticalArrangement = Arrangement.spacedBy(gap),
    content = content,
)

/**
 * As many columns of cards with a picture as fit; larger text makes a [width] larger, so that words keep their room.
 *
 * @param narrow the width on a phone, if it is another.
 */
@Composable
fun pictureCardColumns(width: Dp, narrow: Dp = width): GridCells {
    val scale = LocalDensity.current.fontScale.coerceAtMost(MAX_SCALE)
    return remember(width, narrow, scale) {
        object : GridCells {
            override fun Density.calculateCrossAxisCellSizes(availableSize: Int, spacing: Int): List<Int> {
                val card = if (availableSize < PHONE.roundToPx()) narrow else width
                return with(GridCells.Adaptive(card * scale)) { calculateCrossAxisCellSizes(availableSize, spacing) }
            }
        }
    }
}

/** What is as wide as the grid. */
fun LazyGridScope.wholeRow(key: Any, content: @Composable LazyGridItemScope.() -> Unit) =
    item(key, { GridItemSpan(maxLineSpan) }, content = content)

/** Grids narrower than this are those of phones. */
private val PHONE = 480.dp

/** Above this scale, text on the cards only wraps more; a phone then shows one card per row. */
private const val MAX_SCALE = 1.4f
