package robotran.world.geometry

/**
 * Simplifies the line through [points] to fewer points with a max distance of [tolerance] (Ramer-Douglas-Peucker).
 * Keeps the ends; consecutive points differ.
 */
fun simplified(points: List<Point>, tolerance: Double): List<Point> {
    val distinct = points.filterIndexed { number, point -> number == 0 || point != points[number - 1] }
    if (distinct.size < MIN) return distinct
    val kept = BooleanArray(distinct.size)
    kept[0] = true
    kept[distinct.lastIndex] = true
    val open = ArrayDeque(listOf(0 to distinct.lastIndex))
    while (open.isNotEmpty()) {
        val (from, to) = open.removeLast()
        val furthest = (from + 1..<to).maxByOrNull { distance(distinct[it], distinct[from], distinct[to]) } ?: continue
        if (distance(distinct[furthest], distinct[from], distinct[to]) > tolerance) {
            kept[furthest] = true
            open += from to furthest
            open += furthest to to
        }
    }
    val line = distinct.filterIndexed { number, _ -> kept[number] }
    return line.filterIndexed { number, point -> number == 0 || point != line[number - 1] }
}

private const val MIN = 3
