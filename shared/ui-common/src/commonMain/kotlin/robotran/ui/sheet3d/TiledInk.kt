package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import robotran.scene3d.camera.Projection
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.TrailPiece
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetTransform
import robotran.world.Penbot
import robotran.world.RobotPlacement
import robotran.world.geometry.Point
import robotran.world.geometry.length

/**
 * Which ink the tiles have already. The newest is drawn in perspective, piece by piece, until there is so much of it
 * that it pays to draw its tiles again.
 */
internal class TiledInk(private val transform: SheetTransform) {
    private var tiled: List<InkStroke> = emptyList()
    private var now: List<InkStroke> = emptyList()
    private var tail: List<InkStroke> = emptyList()
    private var frames = 0
    private var trail: List<TrailPiece> = emptyList()
    private var hasTrail = false

    /** Shows [ink], and [trail] if [hasTrail]. Returns the areas, in pixels, whose tiles must be drawn again. */
    fun update(ink: Ink, hasTrail: Boolean, trail: List<TrailPiece>): List<Rect> =
        updateInk(ink) + updateTrail(hasTrail, trail)

    private fun updateInk(ink: Ink): List<Rect> {
        if (ink.strokes === now) return if (tail.isNotEmpty() && ++frames > MAX_FRAMES) flush() else emptyList()
        now = ink.strokes
        val kept = tiled.indices.takeWhile { it < now.size && continues(tiled[it], now[it]) }.size
        if (kept < tiled.size) {
            // Back in time, or another run.
            val areas = (tiled.drop(kept) + now.drop(kept)).map { areaOf(it.points) }
            tiled = now
            tail = emptyList()
            frames = 0
            return areas
        }
        tail = now.mapIndexedNotNull { number, stroke ->
            val from = tiled.getOrNull(number)?.points?.size ?: 0
            stroke.takeIf { tiled.getOrNull(number) !== stroke }
                ?.let { InkStroke(it.points.drop((from - 2).coerceAtLeast(0)), it.robot) }
        }
        frames++
        return if (frames > MAX_FRAMES || tail.sumOf { it.points.size } > MAX_POINTS) flush() else emptyList()
    }

    private fun flush(): List<Rect> {
        val areas = tail.map { areaOf(it.points) }
        tiled = now
        tail = emptyList()
        frames = 0
        return areas
    }

    /** A trail has the newest piece from its tiles, too; it is redrawn with the ink. */
    private fun updateTrail(hasTrail: Boolean, trail: List<TrailPiece>): List<Rect> {
        if (hasTrail == this.hasTrail && (!hasTrail || trail === this.trail)) return emptyList()
        if (hasTrail && this.hasTrail && tail.isNotEmpty() && frames % TRAIL_FRAMES != 0) return emptyList()
        val before = this.trail
        this.trail = trail
        this.hasTrail = hasTrail
        // A piece that became shorter, back in time, leaves its old area, too.
        return (0 until maxOf(before.size, trail.size))
            .filter { before.getOrNull(it) !== trail.getOrNull(it) }
            .flatMap { listOfNotNull(before.getOrNull(it), trail.getOrNull(it)) }
            .map { areaOf(it.points) }
    }

    private fun continues(old: InkStroke, new: InkStroke): Boolean = new === old ||
        (
            new.robot == old.robot && new.points.size >= old.points.size && new.points.first() === old.points.first() &&
                (old.points.size < 2 || new.points[old.points.size - 2] === old.points[old.points.size - 2])
        )

    private fun areaOf(points: List<Point>): Rect {
        val pixels = points.map(transform::toPixels)
        return Rect(
            pixels.minOf { it.x },
            pixels.minOf { it.y },
            pixels.maxOf { it.x },
            pixels.maxOf { it.y },
        ).inflate(transform.toPixels(Penbot.PEN_LINE_WIDTH) + 1)
    }

    /** The ink that the tiles do not have yet. */
    fun drawTail(scope: DrawScope, robots: List<RobotPlacement>, projection: Projection) {
        for (stroke in tail) {
            val path = Path()
            for ((from, to) in stroke.points.zipWithNext()) path.addGround(ribbon(from, to), projection)
            for (point in stroke.points) path.addGround(dot(point), projection)
            scope.drawPath(path, RobotColours.ink(stroke.robot, robots))
        }
    }

    private fun ribbon(from: Point, to: Point): List<Point> {
        val length = length(to.x - from.x, to.y - from.y)
        if (length == 0.0) return dot(from)
        val x = -(to.y - from.y) / length * HALF
        val y = (to.x - from.x) / length * HALF
        return listOf(
            Point(from.x - x, from.y - y),
            Point(to.x - x, to.y - y),
            Point(to.x + x, to.y + y),
            Point(from.x + x, from.y + y),
        )
    }

    private fun dot(point: Point): List<Point> = DOT.map { (x, y) -> Point(point.x + x * HALF, point.y + y * HALF) }

    private companion object {
        const val HALF = Penbot.PEN_LINE_WIDTH / 2

        /** The most that is drawn piece by piece. */
        const val MAX_POINTS = 60
        const val MAX_FRAMES = 20
        const val TRAIL_FRAMES = 10
        val DOT = listOf(
            1.0 to 0.0,
            0.7 to 0.7,
            0.0 to 1.0,
            -0.7 to 0.7,
            -1.0 to 0.0,
            -0.7 to -0.7,
            0.0 to -1.0,
            0.7 to -0.7,
        )
    }
}
