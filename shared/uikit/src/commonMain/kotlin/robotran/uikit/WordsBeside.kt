package robotran.uikit

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.Layout
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.constrainHeight

/** [words] with [buttons] at their end. Where a word would be broken beside them, the buttons are below. */
@Composable
fun WordsBeside(buttons: @Composable () -> Unit, modifier: Modifier = Modifier, words: @Composable () -> Unit) {
    Layout(
        {
            Box(propagateMinConstraints = true) { words() }
            Row(verticalAlignment = Alignment.CenterVertically) { buttons() }
        },
        modifier,
    ) { (text, row), constraints ->
        val width = constraints.maxWidth
        val buttonRow = row.measure(Constraints(maxWidth = width))
        val room = width - buttonRow.width
        val isBeside = text.minIntrinsicWidth(Constraints.Infinity) <= room
        val wordsWidth = if (isBeside) room else width
        val placed = text.measure(Constraints(wordsWidth, wordsWidth, 0, constraints.maxHeight))
        val high = if (isBeside) maxOf(placed.height, buttonRow.height) else placed.height + buttonRow.height
        val height = constraints.constrainHeight(high)
        layout(width, height) {
            placed.place(0, if (isBeside) (height - placed.height) / 2 else 0)
            buttonRow.place(room, if (isBeside) (height - buttonRow.height) / 2 else placed.height)
        }
    }
}
