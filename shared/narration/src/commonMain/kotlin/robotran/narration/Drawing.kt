package robotran.narration

import robotran.world.geometry.Point
import robotran.world.geometry.normalHeading
import kotlin.math.abs

/** The lines of the drawing to trace, as one would drive along them; null if that takes too many words. */
internal fun RobotScene.drawing(): List<String>? {
    val strokes = world.template?.strokes.orEmpty().filter { it.size > 1 }
    if (strokes.isEmpty() || strokes.size > MAX_STROKES) return null
    return strokes.mapIndexed { index, points ->
        val ways = points.zipWithNext { from, to -> directionOf(to.x - from.x, to.y - from.y) to apart(from, to) }
        val groups = gathered(movesAlong(points, ways))
        if (groups.sumOf { it.moves.size } > MAX_STEPS) return null
        val begin = points.first()
        messages.stroke(
            (index + 1).takeIf { strokes.size > 1 },
            if (isAt(begin)) null else messages.strokePlace(centimetres(pose.distanceTo(begin)), turnTo(begin)),
            sheetDirection(ways.first().first),
            groups.map(::told),
        )
    }
}

/** Whether a line of the drawing to trace begins where the robot is. */
internal val RobotScene.isAtDrawing: Boolean
    get() = world.template?.strokes.orEmpty().any { it.isNotEmpty() && isAt(it.first()) }

private fun RobotScene.isAt(point: Point): Boolean = pose.distanceTo(point) <= AT_ROBOT

/** A closed line ends with the turn to its first part. */
private fun movesAlong(points: List<Point>, ways: List<Pair<Double, Double>>): List<Move> = buildList {
    ways.forEachIndexed { index, (direction, length) ->
        add(Move.Drive(length))
        val isClosed = apart(points.first(), points.last()) < CLOSED
        val next = ways.getOrNull(index + 1) ?: ways.first().takeIf { isClosed } ?: return@forEachIndexed
        add(Move.Turn(normalHeading(next.first - direction)))
    }
}

private fun RobotScene.told(group: MoveGroup): String {
    val steps = group.moves.map {
        if (it is Move.Turn) messages.corner(straightened(it.degrees)) else messages.side(centimetres(it.way))
    }
    return if (group.times == 1) steps.single() else messages.again(group.times, steps)
}

/** In whole degrees; what is nearly straight on is. */
private fun straightened(degrees: Double): Int = wholeDegrees(degrees).takeIf { abs(it) > STRAIGHT } ?: 0

private const val MAX_STROKES = 4
private const val MAX_STEPS = 10

/** In degrees. */
private const val STRAIGHT = 1

/** In centimetres. */
private const val AT_ROBOT = 0.5
private const val CLOSED = 0.1
