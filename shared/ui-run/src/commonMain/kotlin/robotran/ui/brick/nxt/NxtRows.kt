package robotran.ui.brick.nxt

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.nxt.display.DisplaySize
import robotran.nxt.state.NxtState
import robotran.uikit.*

/** Four rows of the display. */
@Composable
internal fun NxtRows(state: NxtState, isLow: Boolean) {
    var rows by remember { mutableStateOf(rowsToShow(state)) }
    var before by remember { mutableStateOf(state.display) }
    if (before != state.display) {
        rows = rowsAfter(rows, before.lines, state)
        before = state.display
    }
    NxtDisplayView(
        state,
        2.dp,
        (if (isLow) Modifier.size(118.dp, 48.dp) else Modifier.size(178.dp, 58.dp))
            .background(NxtColours.FRAME, Shapes.SMALL)
            .padding(if (isLow) 1.dp else 4.dp),
        rows,
    )
}

/** The rows around the marked entry of a menu, or what is shown from its first row on. */
internal fun rowsToShow(state: NxtState): IntRange {
    val lines = state.display.lines
    val marked = state.menu?.takeIf { it.selected >= 0 }?.let { menu ->
        lines.indexOfFirst { it.trim() == menu.entries[menu.selected].take(DisplaySize.COLUMNS).trim() }
    }
    val first = lines.indexOfFirst { it.isNotBlank() }.coerceAtLeast(0)
    return rowsFrom(if (marked != null && marked >= 0) marked - STRIP_ROWS / 2 else first)
}

/** The rows to show after [rows], when the display changes from [before]: what is new is among them. */
internal fun rowsAfter(rows: IntRange, before: List<String>, state: NxtState): IntRange {
    if (state.menu != null) return rowsToShow(state)
    val lines = state.display.lines
    val changed = lines.indices.filter { lines[it] != before.getOrNull(it) && lines[it].isNotBlank() }
    return when {
        changed.isEmpty() -> if (lines.slice(rows).all { it.isBlank() }) rowsToShow(state) else rows
        changed.all { it in rows } -> rows
        changed.last() - changed.first() < STRIP_ROWS -> rowsFrom(changed.first())
        else -> rowsFrom(changed.last() - STRIP_ROWS + 1)
    }
}

private fun rowsFrom(top: Int): IntRange = top.coerceIn(0, DisplaySize.ROWS - STRIP_ROWS).let { it..<it + STRIP_ROWS }

private const val STRIP_ROWS = 4
