package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import robotran.world.RobotColour

/** The RCX: a brick in the robot's colour with its display, buttons and ports, and studs on both ends. */
internal fun brickBody(colour: RobotColour, palette: RobotPalette, round: Round): Body {
    val yellow = palette.brick(colour)
    val outline = round.cutRectangle(
        RobotPlan3D.MIDDLE,
        -RobotPlan3D.HALF_BRICK,
        RobotPlan3D.FRONT,
        RobotPlan3D.HALF_BRICK,
        RobotPlan3D.BRICK_CORNER,
    )
    val shoulder = RobotPlan3D.BRICK_BEVEL
    val top = round.cutRectangle(
        RobotPlan3D.MIDDLE + shoulder,
        -RobotPlan3D.HALF_BRICK + shoulder,
        RobotPlan3D.FRONT - shoulder,
        RobotPlan3D.HALF_BRICK - shoulder,
        RobotPlan3D.BRICK_CORNER,
    )
    return loft(
        listOf(
            Ring(outline, RobotPlan3D.CHASSIS_TOP),
            Ring(outline, RobotPlan3D.BRICK_BASE),
            Ring(outline, RobotPlan3D.BRICK_SHOULDER),
            Ring(top, RobotPlan3D.BRICK_TOP),
        ),
        listOf(palette.motor, yellow, shaded(yellow, BEVEL_BRIGHTNESS)),
        yellow,
        topDecals = topOf(yellow, palette, round),
        sideDecals = { level, edge ->
            if (level == 1 &&
                edge == FRONT_EDGE
            ) {
                listOf(infraredWindow(palette))
            } else {
                emptyList()
            }
        },
    )
}

/** The dark window of the infrared light, at the front. */
private fun infraredWindow(palette: RobotPalette): Decal {
    val x = RobotPlan3D.FRONT
    return Decal(
        doubleArrayOf(x, -1.6, 5.9, x, 1.6, 5.9, x, 1.6, 7.1, x, -1.6, 7.1),
        palette.chassisEdge,
    )
}

private fun topOf(yellow: Int, palette: RobotPalette, round: Round): List<Decal> = buildList {
    val height = RobotPlan3D.BRICK_TOP
    // The panel between the ports, with the display along the robot.
    add(Round.plate(3.0, -2.35, 7.3, 2.35, height, shaded(yellow, PANEL_BRIGHTNESS)))
    add(Round.plate(4.1, -1.55, 6.2, 1.55, height, palette.chassis))
    add(Round.plate(4.3, -1.3, 6.0, 1.3, height, palette.glass))
    for ((place, colour) in BUTTONS.zip(palette.buttons)) {
        add(round.disc(place.first, place.second, height, BUTTON_RADIUS + BUTTON_RIM, palette.chassisEdge))
        add(round.disc(place.first, place.second, height + BUTTON_HEIGHT, BUTTON_RADIUS, colour))
    }
    for ((y, colour) in listOf(PORT_SIDE to palette.bumper, -PORT_SIDE to palette.chassis)) {
        add(Decal(PORTS.map { port(it, y) }, colour, fine = false))
        val places = PORTS.flatMap { x ->
            listOf(-STUD_PLACE, STUD_PLACE).flatMap { along ->
                listOf(
                    x + along to y + STUD_PLACE,
                    x + along to y - STUD_PLACE,
                )
            }
        }
        addAll(round.studs(places, height, colour))
    }
}

/** The plate of a port. */
private fun port(x: Double, y: Double): DoubleArray = Round.flat(
    ConvexPolygon.rectangle(x - PORT_HALF, y - PORT_HALF, x + PORT_HALF, y + PORT_HALF),
    RobotPlan3D.BRICK_TOP,
)

/** The frame on the brick and the light in it, at [x] on the robot. */
internal fun beaconBody(
    palette: RobotPalette,
    round: Round,
    x: Double = (RobotPlan3D.MIDDLE + RobotPlan3D.FRONT) / 2,
): Body {
    fun ring(radius: Double, height: Double) = Ring(round.circle(x, 0.0, radius, BEACON_CORNERS), height)
    return loft(
        listOf(ring(1.0, RobotPlan3D.BRICK_TOP), ring(1.3, 9.0), ring(1.0, 10.0), ring(0.4, RobotPlan3D.BEACON_TOP)),
        listOf(palette.beacon, palette.beacon, palette.beacon),
        palette.beacon,
        smooth = true,
        glows = true,
    )
}

/** The boxes below and behind the brick. */
internal object ChassisBodies {
    fun rear(palette: RobotPalette, round: Round) = chassis(RobotPlan3D.REAR, RobotPlan3D.MIDDLE, palette, round, 0.0)

    fun front(palette: RobotPalette, round: Round) = chassis(RobotPlan3D.MIDDLE, RobotPlan3D.FRONT, palette, round, 1.2)

    /** Black beams with their round holes; [narrower] than the wheels' distance at both sides. */
    private fun chassis(from: Double, to: Double, palette: RobotPalette, round: Round, narrower: Double): Body {
        val half = RobotPlan3D.HALF_CHASSIS - narrower
        return prism(
            ConvexPolygon.rectangle(from, -half, to, half),
            RobotPlan3D.CHASSIS_BOTTOM,
            RobotPlan3D.CHASSIS_TOP,
            palette.chassis,
            sideDecals = { _, edge ->
                when (edge) {
                    0 -> holes(from, to, -half, palette, round)
                    2 -> holes(from, to, half, palette, round)
                    else -> emptyList()
                }
            },
        )
    }

    /** The holes of a beam, at LEGO's distance of 8 mm. */
    private fun holes(from: Double, to: Double, y: Double, palette: RobotPalette, round: Round): List<Decal> {
        val count = ((to - from) / HOLE_STEP).toInt()
        val holes = List(count) {
            val ring = round.circle(from + (it + 0.5) * (to - from) / count, HOLE_HEIGHT, HOLE_RADIUS, HOLE_CORNERS)
            DoubleArray(HOLE_CORNERS * 3) { part ->
                when (part % 3) {
                    0 -> ring.x(part / 3)
                    1 -> y
                    else -> ring.y(part / 3)
                }
            }
        }
        return listOf(Decal(holes, palette.motor))
    }

    fun motor(left: Boolean, palette: RobotPalette): Body {
        val from = if (left) 0.35 else -3.9
        return prism(
            ConvexPolygon.rectangle(-4.7, from, -1.5, from + 3.55),
            RobotPlan3D.CHASSIS_TOP,
            6.6,
            palette.motor,
            shaded(palette.motor, MOTOR_TOP),
            topDecals = listOf(
                Round.plate(-4.3, from + 0.4, -1.9, from + 3.15, 6.6, shaded(palette.motor, MOTOR_LID)),
            ),
        )
    }

    /** What holds the pen between the wheels. */
    fun holder(palette: RobotPalette, round: Round): Body = prism(
        round.cutRectangle(-1.1, -1.1, 1.1, 1.1, 0.4),
        RobotPlan3D.CHASSIS_TOP,
        RobotPlan3D.HOLDER_TOP,
        palette.chassis,
        palette.chassisEdge,
    )

    fun caster(palette: RobotPalette, round: Round): Body =
        prism(round.circle(4.6, 0.0, 0.8, 10), 0.0, RobotPlan3D.CHASSIS_BOTTOM, palette.clip, smooth = true)

    /** Looks down through a hole, or ahead between the bumpers; its lamp is red. */
    fun lightSensor(palette: RobotPalette, looksAhead: Boolean): Body {
        val front = RobotPlan3D.FRONT - 0.05
        return prism(
            ConvexPolygon.rectangle(6.3, -0.8, front, 0.8),
            0.35,
            RobotPlan3D.CHASSIS_BOTTOM,
            palette.lightSensor,
            sideDecals = { _, edge ->
                if (looksAhead && edge == 1) {
                    listOf(
                        Decal(
                            doubleArrayOf(front, -0.4, 0.6, front, 0.4, 0.6, front, 0.4, 1.4, front, -0.4, 1.4),
                            palette.sensorLamp,
                            glows = true,
                        ),
                    )
                } else {
                    emptyList()
                }
            },
        )
    }
}

private const val BEVEL_BRIGHTNESS = 1.02
private const val PANEL_BRIGHTNESS = 0.9
private const val FRONT_EDGE = 2

/** View, On-Off, Prgm and Run, in the order of [RobotPalette.buttons]: the first two are behind the display. */
private val BUTTONS = listOf(3.55 to 0.85, 3.55 to -0.85, 6.75 to 0.85, 6.75 to -0.85)
private const val BUTTON_RADIUS = 0.42
private const val BUTTON_RIM = 0.1
private const val BUTTON_HEIGHT = 0.12

/** Inputs on the left, outputs on the right. */
private val PORTS = listOf(3.5, 5.15, 6.8)
private const val PORT_SIDE = 3.4
private const val PORT_HALF = 0.7
private const val STUD_PLACE = 0.34
private const val BEACON_CORNERS = 12
private const val HOLE_STEP = 1.1
private const val HOLE_RADIUS = 0.26
private const val HOLE_CORNERS = 8
private const val HOLE_HEIGHT = 3.2
private const val MOTOR_TOP = 1.1
private const val MOTOR_LID = 1.25
