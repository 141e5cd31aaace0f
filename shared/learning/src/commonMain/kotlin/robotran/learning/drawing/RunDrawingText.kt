package robotran.learning.drawing

import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * The text of [drawing], a line for each thing: `robot` and `block` with x, y and degrees, `ink` with the index of the
 * robot, the x and y of the first point, and from there the ways to the next ones. Lengths are millimetres.
 */
internal fun writeRunDrawing(drawing: RunDrawing): String = listOf(
    drawing.robots.map { poseLine(ROBOT, it) },
    drawing.blocks.map { poseLine(BLOCK, it) },
    drawing.lines.map(::lineOf),
).flatten().joinToString("\n")

/** Reads a drawing that [RunDrawing.text] wrote; null if [text] is none, or longer than any. */
fun readRunDrawing(text: String): RunDrawing? {
    if (text.length > RunDrawing.MAX_CHARACTERS) return null
    val lines = text.split('\n').map { it.split(' ') }
    val poses = lines.filter { it.first() != INK }.map { line -> line.first() to (poseIn(line) ?: return null) }
    val ink = lines.filter { it.first() == INK }.map { inkIn(it) ?: return null }
    val (robots, blocks) = poses.partition { it.first == ROBOT }
    if (robots.isEmpty() || robots.size > WorldLimits.MAXIMUM_ROBOTS) return null
    if (blocks.size > WorldLimits.MAXIMUM_BLOCKS || blocks.any { it.first != BLOCK }) return null
    return RunDrawing(robots.map { it.second }, blocks.map { it.second }, ink)
}

private fun poseLine(word: String, pose: Pose) =
    "$word ${millimetres(pose.x)} ${millimetres(pose.y)} ${pose.heading.toInt()}"

/** The line of the text for [line]. */
internal fun lineOf(line: DrawnLine): String {
    val corners = line.points.map { millimetres(it.x) to millimetres(it.y) }
    val ways = corners.zipWithNext { (x, y), (nextX, nextY) -> "${nextX - x} ${nextY - y}" }
    val (x, y) = corners.first()
    return (listOf("$INK ${line.robot} $x $y") + ways).joinToString(" ")
}

private fun poseIn(line: List<String>): Pose? {
    val numbers = numbersIn(line)?.takeIf { it.size == POSE } ?: return null
    val (x, y, heading) = numbers
    if (!isPlace(x, y) || heading !in -HALF_TURN..HALF_TURN) return null
    return Pose(x / MILLIMETRES, y / MILLIMETRES, heading.toDouble())
}

private fun inkIn(line: List<String>): DrawnLine? {
    val numbers = numbersIn(line)?.takeIf { it.size >= POSE && it.size % 2 == 1 } ?: return null
    val ways = numbers.drop(1).chunked(2)
    val places = ways.drop(1).runningFold(ways.first()) { (x, y), (wayX, wayY) -> listOf(x + wayX, y + wayY) }
    if (numbers.first() !in 0..<WorldLimits.MAXIMUM_ROBOTS || places.any { (x, y) -> !isPlace(x, y) }) return null
    return DrawnLine(numbers.first(), places.map { (x, y) -> Point(x / MILLIMETRES, y / MILLIMETRES) })
}

/** The numbers behind the word of [line]; null if one is none, or too large for any. */
private fun numbersIn(line: List<String>): List<Int>? = line.drop(1).map { number ->
    number.toIntOrNull()?.takeIf { it in -MAX_WAY..MAX_WAY } ?: return null
}

private fun isPlace(x: Int, y: Int) = x in -MAX_PLACE..MAX_PLACE && y in -MAX_PLACE..MAX_PLACE

private const val ROBOT = "robot"
private const val BLOCK = "block"
private const val INK = "ink"

/** How many numbers a pose has, and a dot. */
private const val POSE = 3
internal const val HALF_TURN = 180
private val MAX_PLACE = millimetres(WorldLimits.MAXIMUM_COORDINATE)

/** From one end of all places to the other. */
private val MAX_WAY = MAX_PLACE * 2
