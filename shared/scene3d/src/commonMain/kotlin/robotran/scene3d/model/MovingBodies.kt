package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import kotlin.math.PI
import kotlin.math.floor

/**
 * The wheels of a robot.
 *
 * @property inner the distance of a tyre's inner side from the middle of the robot; [outer] that of its outer side.
 */
internal class WheelShape(val radius: Double, val inner: Double, val outer: Double) {
    companion object {
        val PENBOT = WheelShape(RobotPlan3D.WHEEL_RADIUS, RobotPlan3D.WHEEL_INNER, RobotPlan3D.WHEEL_OUTER)
    }
}

/** The parts of a robot that move: wheels, bumpers and the pen. */
internal class MovingBodies(
    private val palette: RobotPalette,
    private val round: Round,
    private val wheels: WheelShape = WheelShape.PENBOT,
) {
    /** Rims and spokes are as large as on the penbot, relative to the tyre. */
    private val scale = wheels.radius / RobotPlan3D.WHEEL_RADIUS

    /**
     * A wheel on the axle, [left] or right of the robot, after [turn] turns forwards. Its treads are in turn light and
     * dark and its rim has spokes, so that one sees it turn.
     */
    fun wheel(left: Boolean, turn: Double): Body {
        val inner = if (left) wheels.inner else -wheels.outer
        val outer = if (left) wheels.outer else -wheels.inner
        // Forwards, the top of the wheel moves to the front: seen from the left, clockwise.
        val angle = -(turn - floor(turn)) * 2 * PI
        val x = DoubleArray(TREADS) { wheels.radius * round.cosine(angle + it * 2 * PI / TREADS) }
        val z = DoubleArray(TREADS) { wheels.radius * (1 + round.sine(angle + it * 2 * PI / TREADS)) }
        val faces = mutableListOf<Face>()
        for (tread in 0 until TREADS) {
            val next = (tread + 1) % TREADS
            val corners = doubleArrayOf(
                x[tread],
                inner,
                z[tread],
                x[tread],
                outer,
                z[tread],
                x[next],
                outer,
                z[next],
                x[next],
                inner,
                z[next],
            )
            faces += Face(corners, if (tread % 2 == 0) palette.tyre else palette.tread, smooth = true)
        }
        faces += side(x, z, outer, outside = true, angle, decorated = left)
        faces += side(x, z, inner, outside = false, angle, decorated = !left)
        return Body(
            ConvexPolygon.rectangle(-wheels.radius, inner, wheels.radius, outer),
            0.0,
            2 * wheels.radius,
            faces,
        )
    }

    /** The side of a wheel at [y]: towards larger y for [outside]; with a hub if it is the outer side of the robot. */
    private fun side(
        x: DoubleArray,
        z: DoubleArray,
        y: Double,
        outside: Boolean,
        angle: Double,
        decorated: Boolean,
    ): Face {
        val corners = DoubleArray(TREADS * 3) {
            val corner = if (outside) TREADS - 1 - it / 3 else it / 3
            when (it % 3) {
                0 -> x[corner]
                1 -> y
                else -> z[corner]
            }
        }
        val decals = if (decorated) hub(y, angle) else emptyList()
        return Face(corners, palette.tyre, decals)
    }

    private fun hub(y: Double, angle: Double): List<Decal> = buildList {
        add(Decal(upright(0.0, HUB_RADIUS * scale, HUB_CORNERS, y, angle), palette.hub, fine = false))
        add(Decal(List(SPOKES) { gap(angle + it * 2 * PI / SPOKES, y) }, palette.chassisEdge))
        add(Decal(upright(0.0, AXLE_RADIUS, AXLE_CORNERS, y, angle), palette.chassisEdge))
    }

    /** A circle in the plane of the wheel. */
    private fun upright(from: Double, radius: Double, corners: Int, y: Double, angle: Double) =
        DoubleArray(corners * 3) {
            val way = angle + from + it / 3 * 2 * PI / corners
            when (it % 3) {
                0 -> radius * round.cosine(way)
                1 -> y
                else -> wheels.radius + radius * round.sine(way)
            }
        }

    /** The gap between two spokes. */
    private fun gap(way: Double, y: Double): DoubleArray {
        val places = listOf(
            GAP_INNER to way - GAP_INNER_ANGLE,
            GAP_OUTER to way - GAP_OUTER_ANGLE,
            GAP_OUTER to way + GAP_OUTER_ANGLE,
            GAP_INNER to way + GAP_INNER_ANGLE,
        )
        return DoubleArray(places.size * 3) {
            val (radius, angle) = places[it / 3]
            when (it % 3) {
                0 -> radius * scale * round.cosine(angle)
                1 -> y
                else -> wheels.radius + radius * scale * round.sine(angle)
            }
        }
    }

    /** A plate in front of the robot, [left] or right; its arm leads to the chassis. */
    fun bumper(left: Boolean): Body {
        val from = if (left) RobotPlan3D.BUMPER_INNER else -RobotPlan3D.BUMPER_OUTER
        val to = if (left) RobotPlan3D.BUMPER_OUTER else -RobotPlan3D.BUMPER_INNER
        return prism(
            round.cutRectangle(RobotPlan3D.BUMPER_BACK, from, RobotPlan3D.BUMPER_BACK + 0.8, to, 0.3),
            RobotPlan3D.BUMPER_BOTTOM,
            RobotPlan3D.BUMPER_TOP,
            palette.bumper,
            shaded(palette.bumper, TOP_BRIGHTNESS),
        )
    }

    fun bumperArm(left: Boolean): Body {
        val middle = (if (left) 1 else -1) * (RobotPlan3D.BUMPER_INNER + RobotPlan3D.BUMPER_OUTER) / 2
        return prism(
            ConvexPolygon.rectangle(RobotPlan3D.FRONT, middle - 0.4, RobotPlan3D.BUMPER_BACK, middle + 0.4),
            RobotPlan3D.CHASSIS_BOTTOM + 0.2,
            RobotPlan3D.CHASSIS_BOTTOM + 1.0,
            palette.bumperEdge,
        )
    }

    /** What is seen above its holder of the barrel, in the colour of its ink; [lift] centimetres above the paper. */
    fun penBarrel(ink: Int, lift: Double): Body {
        fun ring(radius: Double, height: Double) = Ring(round.circle(0.0, 0.0, radius, PEN_CORNERS), height)
        return loft(
            listOf(
                ring(RobotPlan3D.PEN_RADIUS, RobotPlan3D.HOLDER_TOP),
                ring(RobotPlan3D.PEN_RADIUS, RobotPlan3D.PEN_TOP - CAP + lift),
                ring(RobotPlan3D.PEN_RADIUS, RobotPlan3D.PEN_TOP - CAP / 4 + lift),
                ring(RobotPlan3D.PEN_RADIUS * 0.7, RobotPlan3D.PEN_TOP + lift),
            ),
            listOf(palette.clip, ink, ink),
            ink,
            smooth = true,
        )
    }

    /** The tip below the chassis. */
    fun penTip(ink: Int): Body {
        fun ring(radius: Double, height: Double) = Ring(round.circle(0.0, 0.0, radius, PEN_CORNERS), height)
        return loft(
            listOf(
                ring(RobotPlan3D.PEN_TIP_RADIUS, 0.0),
                ring(RobotPlan3D.PEN_RADIUS, 1.0),
                ring(RobotPlan3D.PEN_RADIUS, RobotPlan3D.CHASSIS_BOTTOM),
            ),
            listOf(ink, palette.clip),
            palette.clip,
            smooth = true,
        )
    }

    private companion object {
        const val TREADS = 20
        const val HUB_RADIUS = 1.55
        const val HUB_CORNERS = 14
        const val SPOKES = 6
        const val AXLE_RADIUS = 0.3
        const val AXLE_CORNERS = 8
        const val GAP_INNER = 0.55
        const val GAP_OUTER = 1.3
        const val GAP_INNER_ANGLE = 0.28
        const val GAP_OUTER_ANGLE = 0.36
        const val PEN_CORNERS = 10
        const val CAP = 1.4
        const val TOP_BRIGHTNESS = 1.08
    }
}
