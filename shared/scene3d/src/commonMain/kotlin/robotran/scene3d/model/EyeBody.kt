package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import robotran.scene3d.geometry.Vector3
import robotran.world.geometry.Point
import kotlin.math.PI

/**
 * The eyes: two round tiles on the front edge of the brick, tilted so that they are seen from ahead and from above.
 * Their pupils and lids have the measures of the robot from above.
 *
 * @param lid the colour of the brick, which lids and backs have, too; [edge] that of its edge.
 * @param ahead where they are on the robot.
 * @param aside their distance from the middle.
 */
internal class EyeBodies(
    private val lid: Int,
    private val edge: Int,
    palette: RobotPalette,
    private val round: Round,
    ahead: Double = PLACE_AHEAD,
    private val aside: Double = PLACE_ASIDE,
) {
    private val placeAhead = ahead
    private val rim = palette.chassisEdge
    private val white = palette.eye
    private val dark = palette.pupil
    private val down = round.sine(TILT)
    private val ahead = round.cosine(TILT)
    private var latest: Pair<RobotFace, List<Body>>? = null

    /** The left one and the right one. */
    fun of(face: RobotFace): List<Body> {
        latest?.let { (known, bodies) -> if (known == face) return bodies }
        return listOf(aside, -aside).map { eye(it, face) }.also { latest = face to it }
    }

    private fun eye(aside: Double, face: RobotFace): Body {
        val front = List(CORNERS) { onFront(aside, circlePoint(it, CORNERS, RADIUS)) }
        val back = front.map { Vector3(it.x - ahead * DEPTH, it.y, it.z - down * DEPTH) }
        val faces = buildList {
            add(Face(corners(front), rim, decals(aside, face)))
            for (corner in 0 until CORNERS) {
                val next = (corner + 1) % CORNERS
                add(Face(corners(listOf(front[corner], back[corner], back[next], front[next])), lid, smooth = true))
            }
            add(Face(corners(back.reversed()), lid))
        }
        val all = front + back
        val footprint = checkNotNull(ConvexPolygon.around(all.map { Point(it.x, it.y) }))
        return Body(footprint, all.minOf { it.z }, all.maxOf { it.z }, faces)
    }

    private fun decals(aside: Double, face: RobotFace): List<Decal> {
        fun disc(middle: Point, radius: Double, colour: Int, fine: Boolean = false) = Decal(
            corners(List(CORNERS) { onFront(aside, circlePoint(it, CORNERS, radius, middle)) }),
            colour,
            fine,
        )

        fun segment(middle: Double, sweep: Double, colour: Int, radius: Double = INNER) = Decal(
            corners(
                List(LID_CORNERS) {
                    val angle = middle + sweep * (it.toDouble() / (LID_CORNERS - 1) - 0.5)
                    onFront(aside, Point(radius * round.cosine(angle), radius * round.sine(angle)))
                },
            ),
            colour,
            fine = false,
        )

        if (face.lids == RobotFace.Lids.SHUT) {
            return listOf(disc(Point(0.0, 0.0), INNER, lid), segment(LOWER, PI * 0.8, edge, INNER * 0.8)) +
                segment(LOWER, PI * 0.72, lid, INNER * 0.8)
        }
        val pupil = Point(face.gazeForwards * GAZE, -face.gazeRightwards * GAZE)
        val open = listOf(
            disc(Point(0.0, 0.0), INNER, white),
            disc(pupil, PUPIL, dark),
            disc(Point(pupil.x - GLINT_ASIDE, pupil.y + GLINT_ASIDE), PUPIL * GLINT, white, fine = true),
        )
        return when (face.lids) {
            RobotFace.Lids.HANGING -> {
                val tilted = UPPER + if (aside > 0) -HANGING_TILT else HANGING_TILT
                open + segment(tilted, HANGING_SWEEP + EDGE_SWEEP, edge) + segment(tilted, HANGING_SWEEP, lid)
            }

            RobotFace.Lids.RAISED -> {
                open + segment(LOWER, RAISED_SWEEP + EDGE_SWEEP, edge) + segment(LOWER, RAISED_SWEEP, lid)
            }

            else -> open
        }
    }

    private fun circlePoint(corner: Int, corners: Int, radius: Double, middle: Point = Point(0.0, 0.0)): Point {
        val angle = corner * 2 * PI / corners
        return Point(middle.x + radius * round.cosine(angle), middle.y + radius * round.sine(angle))
    }

    /** [point] on the tile, x towards its lower edge, which is ahead, y to the robot's left. */
    private fun onFront(aside: Double, point: Point) = Vector3(
        placeAhead + point.x * down,
        aside + point.y,
        RobotPlan3D.BRICK_TOP + RADIUS * ahead + DEPTH * down - point.x * ahead,
    )

    private fun corners(points: List<Vector3>) = DoubleArray(points.size * 3) {
        val point = points[it / 3]
        when (it % 3) {
            0 -> point.x
            1 -> point.y
            else -> point.z
        }
    }

    private companion object {
        const val CORNERS = 14
        const val LID_CORNERS = 9

        /** In centimetres. */
        const val RADIUS = 1.4
        const val INNER = 1.22
        const val DEPTH = 0.6
        const val PLACE_AHEAD = 6.75
        const val PLACE_ASIDE = 2.45
        const val PUPIL = 0.66
        const val GAZE = 0.5
        const val GLINT = 0.34
        const val GLINT_ASIDE = 0.2

        /** How far the tiles look up, as an angle above the horizon. */
        const val TILT = 0.75

        /** The directions of the lids on a tile. */
        const val UPPER = PI
        const val LOWER = 0.0
        const val HANGING_TILT = 0.49
        const val HANGING_SWEEP = 2.97
        const val RAISED_SWEEP = 2.27
        const val EDGE_SWEEP = 0.28
    }
}
