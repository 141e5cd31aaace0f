package robotran.learning.drawing

import robotran.simulation.state.InkStroke
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.simplified
import kotlin.math.roundToInt

/** The drawing of these things, as exact as [RunDrawing.MAX_CHARACTERS] allow. */
internal fun drawingOf(robots: List<Pose>, blocks: List<Pose>, strokes: List<InkStroke>): RunDrawing {
    val things = RunDrawing(robots.map(::rounded), blocks.map(::rounded), emptyList()).takeIf { it.isShort }
        ?: RunDrawing(robots.map(::rounded), emptyList(), emptyList())
    val drawings = TOLERANCES.asSequence().map { tolerance ->
        things.copy(lines = strokes.map { it.within(tolerance) })
    }
    return drawings.firstOrNull { it.isShort } ?: things.withAsManyOf(drawings.last().lines)
}

private val RunDrawing.isShort: Boolean get() = text.length <= RunDrawing.MAX_CHARACTERS

/** The first of [lines] that there is room for. */
private fun RunDrawing.withAsManyOf(lines: List<DrawnLine>): RunDrawing {
    var room = RunDrawing.MAX_CHARACTERS - text.length
    return copy(
        lines = lines.takeWhile { line ->
            room -= lineOf(line).length + 1
            room >= 0
        },
    )
}

private fun InkStroke.within(tolerance: Double): DrawnLine {
    val line = simplified(points, tolerance).map { Point(centimetres(it.x), centimetres(it.y)) }
    return DrawnLine(robot, line.filterIndexed { number, point -> number == 0 || point != line[number - 1] })
}

private fun rounded(pose: Pose): Pose {
    val heading = pose.heading.roundToInt()
    // Half a turn has one number.
    val turned = if (heading == -HALF_TURN) HALF_TURN else heading
    return Pose(centimetres(pose.x), centimetres(pose.y), turned.toDouble())
}

/** To whole millimetres. What has left the sheet for good is no further away than things in a world may be. */
private fun centimetres(value: Double): Double =
    millimetres(value.coerceIn(-WorldLimits.MAXIMUM_COORDINATE, WorldLimits.MAXIMUM_COORDINATE)) / MILLIMETRES

internal fun millimetres(value: Double): Int = (value * MILLIMETRES).roundToInt()

internal const val MILLIMETRES = 10.0

/** In centimetres, the most exact first. A picture of a lesson is about a pixel to half a centimetre. */
private val TOLERANCES = listOf(0.1, 0.2, 0.4, 0.8, 1.6)
