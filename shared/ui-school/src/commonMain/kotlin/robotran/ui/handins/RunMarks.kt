package robotran.ui.handins

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradedRun
import robotran.assignments.grading.GradingPlan
import robotran.ui.assignment.worldName
import robotran.uikit.*

/**
 * A mark for each run, a row for each world with its name, and a column for each seed: a tick on a filled square where
 * all goals were met, a cross where they were not. What the row of the table says is the same, so it needs no
 * accessibility text.
 *
 * @param hasNames false in a table of many rows, where worlds only stand apart.
 */
@Composable
internal fun RunMarks(
    graded: GradedHandIn.Graded,
    plan: GradingPlan,
    modifier: Modifier = Modifier,
    hasNames: Boolean = true,
) = BoxWithConstraints(modifier) {
    val scale = LocalDensity.current.fontScale.coerceAtMost(MAX_SCALE)
    val cell = (if (plan.seeds.count() > FEW) SMALL_CELL else CELL) * scale
    val columns = (maxWidth / cell).toInt().coerceIn(1, MAX_COLUMNS)
    Column(verticalArrangement = Arrangement.spacedBy(if (hasNames) Space.HAIR else Space.TINY)) {
        for (world in plan.worlds) {
            if (hasNames) WorldName(worldName(world.name), plan.seeds)
            Column(verticalArrangement = Arrangement.spacedBy(Space.HAIR)) {
                graded.runsIn(world.name).chunked(columns).forEach { MarksRow(it, cell) }
            }
        }
    }
}

/** The world of a row, and the seeds of its columns. */
@Composable
private fun WorldName(name: String, seeds: IntRange) = ShortenedText(
    if (seeds.first == seeds.last) name else "$name, ${seeds.first}–${seeds.last}",
    TextStyle(LocalRobotranColours.current.quiet, TextSizes.SMALL, lineHeight = LineHeights.TIGHT),
    maxLines = 1,
)

@Composable
private fun MarksRow(runs: List<GradedRun>, cell: Dp) {
    val colours = LocalRobotranColours.current
    Canvas(Modifier.size(cell * runs.size, cell)) {
        runs.forEachIndexed { index, run ->
            translate(left = index * cell.toPx()) { drawMark(run.grade.passed, cell.toPx(), colours) }
        }
    }
}

/** A mark in a square with sides of [cell] pixels, with a gap to the next one. */
internal fun DrawScope.drawMark(isMet: Boolean, cell: Float, colours: RobotranColours) {
    val gap = cell * GAP
    val side = cell - gap
    val corner = Offset(gap / 2, gap / 2)
    val stroke = Stroke((side * STROKE).coerceAtLeast(1f), cap = StrokeCap.Round, join = StrokeJoin.Round)

    fun at(x: Float, y: Float) = Offset(corner.x + side * x, corner.y + side * y)
    if (isMet) {
        drawRect(colours.good, corner, Size(side, side))
        val tick = Path().apply {
            at(0.2f, 0.55f).let { moveTo(it.x, it.y) }
            at(0.42f, 0.76f).let { lineTo(it.x, it.y) }
            at(0.82f, 0.26f).let { lineTo(it.x, it.y) }
        }
        drawPath(tick, colours.pane, style = stroke)
    } else {
        drawRect(colours.errorPane, corner, Size(side, side))
        val cross = Path().apply {
            for ((from, to) in listOf(at(0.22f, 0.22f) to at(0.78f, 0.78f), at(0.78f, 0.22f) to at(0.22f, 0.78f))) {
                moveTo(from.x, from.y)
                lineTo(to.x, to.y)
            }
        }
        drawPath(cross, colours.error, style = stroke)
    }
}

private val CELL = 16.dp
private val SMALL_CELL = 12.dp

/** Up to here the marks are larger. */
private const val FEW = 10
private const val MAX_COLUMNS = 20
private const val MAX_SCALE = 1.5f
private const val GAP = 0.14f
private const val STROKE = 0.14f
