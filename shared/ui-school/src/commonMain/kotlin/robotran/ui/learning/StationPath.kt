package robotran.ui.learning

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.layout.Layout
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** The [stops] along a path that winds to and fro, as many in a row as there is room for. */
@Composable
internal fun StationPath(stops: List<Stop>) {
    val density = LocalDensity.current
    val colours = LocalRobotranColours.current
    val notes = if (stops.any { it.note != null }) 1 else 0
    val rowHeight = with(density) { STATION_SIZE + STATION_GAP * 2 + (TITLE_LINE * (TITLE_LINES + notes)).toDp() }
    BoxWithConstraints(Modifier.fillMaxWidth().padding(top = 8.dp)) {
        val columns = (maxWidth / (MIN_CELL * density.fontScale)).toInt().coerceIn(1, MAX_COLUMNS)
        val rows = stops.chunked(columns)
        val cell = maxWidth / columns
        Column(
            Modifier.semantics { isTraversalGroup = true }.drawBehind {
                val centres = stops.indices.map { centreOf(it, columns, cell, rowHeight) }
                centres.zipWithNext().forEachIndexed { place, (from, to) ->
                    val isDone = stops[place].isDone
                    val colour = if (isDone) RobotranColours.RUN_GREEN else colours.line
                    drawLine(colour, from, to, WAY_WIDTH.toPx(), StrokeCap.Round)
                }
            },
        ) {
            rows.forEachIndexed { row, inRow ->
                StationRow(columns, isBack = row % 2 == 1) {
                    for (stop in inRow) Station(stop, stops.indexOf(stop) + 1, rowHeight, Modifier)
                }
            }
        }
    }
}

/** Cells of equal width, from right to left if it goes [isBack]. The Tab key follows the stops, not the screen. */
@Composable
private fun StationRow(columns: Int, isBack: Boolean, stations: @Composable () -> Unit) =
    Layout(stations, Modifier.fillMaxWidth()) { measurables, constraints ->
        val cell = constraints.maxWidth / columns
        val placed = measurables.map { it.measure(Constraints.fixedWidth(cell)) }
        layout(constraints.maxWidth, placed.maxOf { it.height }) {
            placed.forEachIndexed { place, station ->
                station.place(cell * (if (isBack) columns - 1 - place else place), 0)
            }
        }
    }

/** The middle of the station with this [index]; every second row goes back. */
private fun DrawScope.centreOf(index: Int, columns: Int, cell: Dp, rowHeight: Dp): Offset {
    val row = index / columns
    val column = if (row % 2 == 0) index % columns else columns - 1 - index % columns
    return Offset(
        (cell * (column + 0.5f)).toPx(),
        (rowHeight * row + STATION_GAP + STATION_SIZE / 2).toPx(),
    )
}

internal val STATION_SIZE = 48.dp
internal val STATION_GAP = 8.dp
internal val TITLE_LINE = LineHeights.SMALL
internal const val TITLE_LINES = 3
private val MIN_CELL = 100.dp
private const val MAX_COLUMNS = 6
private val WAY_WIDTH = 6.dp
