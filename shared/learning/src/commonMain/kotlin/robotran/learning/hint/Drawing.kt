package robotran.learning.hint

import robotran.world.GoalCondition
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.math.sqrt

internal fun lengthOf(points: List<Point>): Double = points.zipWithNext().sumOf { (a, b) -> distance(a, b) }

/** Too little was drawn, or the robot stopped before its place. */
internal fun Attempt.tooShort(): HintMatch? {
    val wanted = wantedInk()
    val isShort = if (wanted != null) run.ink.lengthCentimetres in LITTLE..wanted * SHORT else stoppedShort() == true
    return if (isShort) HintMatch() else null
}

/** Too much was drawn, or the robot went beyond its place. */
internal fun Attempt.tooFar(): HintMatch? {
    val wanted = wantedInk()
    val isFar = if (wanted != null) run.ink.lengthCentimetres > wanted * FAR else stoppedShort() == false
    return if (isFar) HintMatch() else null
}

/** How much ink the drawing takes, in centimetres; null if there is nothing to draw. */
private fun Attempt.wantedInk(): Double? = when {
    unmetConditions.any { it is GoalCondition.DrawTemplate } -> world.template?.strokes?.sumOf(::lengthOf)
    else -> unmetConditions.filterIsInstance<GoalCondition.InkLength>().firstOrNull()?.atLeast
}

/** Whether the robot ended before the place that it did not reach; null if it missed it in another way. */
private fun Attempt.stoppedShort(): Boolean? {
    val goal = unmetConditions.filterIsInstance<GoalCondition.Reach>().firstOrNull { it.who == null } ?: return null
    val target = centreOf(goal.region)
    val end = Point(run.robot.pose.x, run.robot.pose.y)
    val before = run.trail.firstOrNull { it.robot == 0 }?.points?.dropLast(1)?.lastOrNull() ?: return null
    val way = distance(before, end)
    if (way < LITTLE) return null
    // How much further, on the last stretch, the target is.
    val further = ((target.x - end.x) * (end.x - before.x) + (target.y - end.y) * (end.y - before.y)) / way
    val aside = sqrt(maxOf(0.0, distance(target, end).let { it * it } - further * further))
    return if (aside > distance(target, end) * ASIDE) null else further > 0
}

/** The middle of [shape]: its centre, or the mean of its corners. */
private fun centreOf(shape: Shape): Point = when (shape) {
    is Shape.Circle -> shape.centre
    is Shape.Rectangle -> shape.centre
    is Shape.Polygon -> Point(shape.corners.sumOf { it.x } / shape.corners.size, shape.corners.sumOf { it.y } / shape.corners.size)
}

/** Whether the ink, reflected in the line that the robot looked along at first, covers most of the template. */
internal fun isMirrorImage(attempt: Attempt): Boolean {
    val template = attempt.world.template ?: return false
    val start = attempt.run.trail.firstOrNull { it.robot == 0 }?.points ?: return false
    val origin = start.firstOrNull() ?: return false
    val ahead = start.firstOrNull { distance(it, origin) > LITTLE } ?: return false
    val way = distance(origin, ahead)
    val axis = Point((ahead.x - origin.x) / way, (ahead.y - origin.y) / way)
    val mirrored = attempt.run.ink.strokes.map { stroke -> stroke.points.map { reflected(it, origin, axis) } }
    val wanted = template.strokes.flatMap(::dotted)
    fun share(strokes: List<List<Point>>) = wanted.count { dot -> strokes.any { isNear(dot, it) } }.toDouble() / wanted.size
    return share(mirrored) > MOST && share(attempt.run.ink.strokes.map { it.points }) < MOST
}

private fun reflected(point: Point, origin: Point, axis: Point): Point {
    val x = point.x - origin.x
    val y = point.y - origin.y
    val along = x * axis.x + y * axis.y
    return Point(origin.x + 2 * along * axis.x - x, origin.y + 2 * along * axis.y - y)
}

/** Points on [stroke], about a centimetre apart. */
private fun dotted(stroke: List<Point>): List<Point> = stroke.zipWithNext().flatMap { (a, b) ->
    val parts = maxOf(1, distance(a, b).toInt())
    List(parts) { Point(a.x + (b.x - a.x) * it / parts, a.y + (b.y - a.y) * it / parts) }
}

private fun isNear(dot: Point, stroke: List<Point>): Boolean = stroke.zipWithNext().any { (a, b) ->
    val x = b.x - a.x
    val y = b.y - a.y
    val square = x * x + y * y
    val along = if (square == 0.0) 0.0 else (((dot.x - a.x) * x + (dot.y - a.y) * y) / square).coerceIn(0.0, 1.0)
    distance(dot, Point(a.x + along * x, a.y + along * y)) < NEAR
}

private fun distance(a: Point, b: Point): Double = sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y))

private const val SHORT = 0.9
private const val FAR = 1.1

/** A target may be this share of its distance beside the robot's last stretch. */
private const val ASIDE = 0.5
private const val MOST = 0.85

/** In centimetres. */
private const val NEAR = 1.5
