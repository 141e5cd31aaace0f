package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.Layout
import androidx.compose.ui.layout.Placeable
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp

/** The buttons of a sheet. The first button is always at the lower left, the last at the lower right if there is room, otherwise above it. */
@Composable
fun ButtonRows(modifier: Modifier, buttons: @Composable () -> Unit) = Layout(buttons, modifier) { all, limits ->
    val gap = GAP.roundToPx()
    val width = limits.maxWidth
    val placed = all.map { it.measure(Constraints(maxWidth = width)) }
    val rows = mutableListOf(mutableListOf<Placeable>())
    var used = placed.first().width
    for (button in placed.drop(1).asReversed()) {
        if (used + gap + button.width > width) {
            rows += mutableListOf<Placeable>()
            used = 0
        }
        rows.last() += button
        used += gap + button.width
    }
    val heights = rows.mapIndexed { index, row ->
        maxOf(row.maxOfOrNull { it.height } ?: 0, if (index == 0) placed.first().height else 0)
    }
    val height = heights.sum()
    layout(width, height) {
        placed.first().place(0, height - placed.first().height)
        var bottom = height
        rows.forEachIndexed { index, row ->
            var right = width
            for (button in row) {
                button.place(right - button.width, bottom - button.height)
                right -= button.width + gap
            }
            bottom -= heights[index]
        }
    }
}

private val GAP = 8.dp
