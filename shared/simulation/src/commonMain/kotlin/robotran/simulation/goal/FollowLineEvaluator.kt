package robotran.simulation.goal

import robotran.simulation.state.GoalStatus
import robotran.world.GoalCondition
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.length

/** Evaluates whether the robot's light sensor has followed the line often enough. */
internal class FollowLineEvaluator(
    sentence: String,
    private val goal: GoalCondition.FollowLine,
    private val actor: Actor.OfRobots,
    line: MarkFigure.Line,
) : SingleGoalEvaluator(sentence) {
    private val laps = if (line.closed) {
        Rounds(
            ArcLengthPath(line).length,
            goal,
        )
    } else {
        EndToEnd(ArcLengthPath(line).length, goal)
    }
    private val tracker = LineTracker(ArcLengthPath(line), goal.tolerance, laps)

    override fun look(scene: Scene) {
        if (scene.isAfter(goal.within)) return tell(GoalStatus.FAILED)
        tracker.moveTo(scene.lightSensor(actor) ?: return)
        tell(if (laps.share >= 1.0) GoalStatus.MET else GoalStatus.PENDING, laps.share)
    }
}

/** null if there is no such line, or if it is a single point. */
internal fun followLineEvaluator(
    sentence: String,
    goal: GoalCondition.FollowLine,
    actor: Actor.OfRobots,
    world: World,
): GoalEvaluator? = world.marks.find { it.name == goal.line && it.isWay() }?.let {
    FollowLineEvaluator(sentence, goal, actor, it.figure as MarkFigure.Line)
}

/** Whether it has at least two different points. */
private fun Mark.isWay() =
    (figure as? MarkFigure.Line)?.let { line -> line.points.any { it != line.points.first() } } == true

/**
 * Tracks a robot along a line. Where the line approaches or crosses itself, the position reachable from the last one
 * counts.
 *
 * @param tolerance max distance from the line.
 * @param laps receives the positions.
 */
internal class LineTracker(private val way: ArcLengthPath, private val tolerance: Double, private val laps: Laps) {
    private val reach = minOf(REACH_IN_TOLERANCES * tolerance, way.length / MIN_REACHES_IN_LINE)
    private val maxStray = STRAY_IN_TOLERANCES * tolerance

    /** The last position along the line, null before the robot has reached it. */
    private var at: Double? = null
    private var place: Point? = null

    /** Distance covered beside the line since the robot left it. */
    private var distanceOffLine = 0.0
    private var searchedAt = -SEARCH_DISTANCE

    fun moveTo(next: Point) {
        val moved = place?.let { length(next.x - it.x, next.y - it.y) } ?: 0.0
        if (place != null && moved == 0.0) return
        place = next
        val near = at?.let { way.nearest(next, it - reach, it + reach) }
        if (near != null && near.distance <= tolerance) {
            goOn(near.at)
        } else {
            distanceOffLine += moved
            if (at == null || distanceOffLine > maxStray) search(next)
        }
    }

    private fun goOn(to: Double) {
        at = to
        distanceOffLine = 0.0
        searchedAt = -SEARCH_DISTANCE
        laps.goOn(to)
    }

    private fun search(place: Point) {
        if (distanceOffLine - searchedAt < SEARCH_DISTANCE) return
        searchedAt = distanceOffLine
        val near = way.nearest(place, 0.0, way.length)
        if (near.distance > tolerance) return
        laps.restartAt(near.at)
        goOn(near.at)
    }

    private companion object {
        /** Max progress along the line between two checks: round a bend of 60 degrees, cut within the tolerance. */
        const val REACH_IN_TOLERANCES = 4.0
        const val MIN_REACHES_IN_LINE = 4.0

        /** Max distance beside the line within which the robot rejoins the line only where it left it. */
        const val STRAY_IN_TOLERANCES = 2.0

        /** Min distance the robot covers between two searches of the whole line, in centimetres. */
        const val SEARCH_DISTANCE = 0.5
    }
}

/** A line as a path with positions from 0 to its [length]; a closed line continues with every lap, and below 0. */
internal class ArcLengthPath(line: MarkFigure.Line) {
    private val isClosed = line.closed
    private val corners = (if (isClosed) line.points + line.points.first() else line.points).withoutRepetition()

    /** The position of each corner. */
    private val places = DoubleArray(corners.size).also { places ->
        for (number in 1..<corners.size) places[number] = places[number - 1] + way(corners[number - 1], corners[number])
    }

    /** In centimetres. */
    val length: Double = places.last()

    class Nearest(val at: Double, val distance: Double)

    /**
     * The position from [from] to [to] nearest to [place]. At most one limit may be beyond the ends of an open line.
     */
    fun nearest(place: Point, from: Double, to: Double): Nearest {
        var offset = if (isClosed) kotlin.math.floor(from / length) * length else 0.0
        var number = pieceAt(from - offset)
        var nearest: Nearest? = null
        while (offset + places[number] <= to) {
            val candidate = nearestOfPiece(number, place, from - offset, to - offset)
            if (nearest == null || candidate.distance < nearest.distance) {
                nearest = Nearest(offset + candidate.at, candidate.distance)
            }
            number++
            if (number == corners.size - 1) {
                if (!isClosed) break
                number = 0
                offset += length
            }
        }
        return nearest ?: Nearest(from, Double.MAX_VALUE)
    }

    private fun nearestOfPiece(number: Int, place: Point, from: Double, to: Double): Nearest {
        val begin = corners[number]
        val end = corners[number + 1]
        val along = places[number + 1] - places[number]
        val directionX = (end.x - begin.x) / along
        val directionY = (end.y - begin.y) / along
        val foot = (place.x - begin.x) * directionX + (place.y - begin.y) * directionY
        val at = foot.coerceIn(
            0.0,
            along,
        ).coerceAtMost(to - places[number]).coerceAtLeast(minOf(from - places[number], along))
        return Nearest(
            places[number] + at,
            length(place.x - begin.x - at * directionX, place.y - begin.y - at * directionY),
        )
    }

    /** Index of the segment between two corners at [place]; the nearest one for a position beyond the ends. */
    private fun pieceAt(place: Double): Int {
        var low = 0
        var high = corners.size - 2
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (places[middle] <= place) low = middle else high = middle - 1
        }
        return low
    }

    private companion object {
        fun way(from: Point, to: Point) = length(to.x - from.x, to.y - from.y)

        fun List<Point>.withoutRepetition() = filterIndexed { number, point ->
            number == 0 ||
                way(this[number - 1], point) > 0.0
        }
    }
}
