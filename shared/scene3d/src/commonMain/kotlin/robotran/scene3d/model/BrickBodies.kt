package robotran.scene3d.model

import robotran.brick.kind.BrickKind
import robotran.world.RobotPlacement

/** A brick of this [kind] around the origin, its upper end at larger y. */
internal fun brickBody(
    kind: BrickKind,
    build: RobotPlacement,
    palette: RobotPalette,
    round: Round,
    halfWidth: Double,
    halfLength: Double,
): Body = when (kind) {
    BrickKind.RCX -> rcxBody(build, palette, round, halfWidth, halfLength)
    BrickKind.NXT, BrickKind.NXT_PYBRICKS -> nxtBody(build, palette, round, halfWidth, halfLength)

    BrickKind.SPIKE_PRIME, BrickKind.SPIKE_ESSENTIAL, BrickKind.TECHNIC_HUB, BrickKind.EV3 -> {
        hubBody(kind, build, palette, round, halfWidth, halfLength)
    }

    BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> microbitBody(build, palette, round, halfWidth, halfLength)
}

/** An RCX with its display and buttons, without the details of the penbot's. */
private fun rcxBody(
    build: RobotPlacement,
    palette: RobotPalette,
    round: Round,
    halfWidth: Double,
    halfLength: Double,
): Body {
    val colour = palette.brick(build.colour)
    val top = RobotPlan3D.BRICK_TOP
    val outline = round.cutRectangle(-halfWidth, -halfLength, halfWidth, halfLength, RobotPlan3D.BRICK_CORNER)
    return prism(
        outline,
        RobotPlan3D.CHASSIS_TOP,
        top,
        colour,
        topDecals = listOf(
            Round.plate(-1.05, -1.55, 1.05, 1.55, top, palette.chassis),
            Round.plate(-0.85, -1.3, 0.85, 1.3, top, palette.glass),
        ) + listOf(-1.7 to 0.85, -1.7 to -0.85, 1.7 to 0.85, 1.7 to -0.85).zip(palette.buttons) { (x, y), button ->
            round.disc(x, y, top, 0.42, button)
        },
    )
}

/**
 * An NXT around the origin, its upper end at larger y: a light face with its display, buttons and ports in a frame of
 * the robot's colour.
 */
private fun nxtBody(
    build: RobotPlacement,
    palette: RobotPalette,
    round: Round,
    halfWidth: Double,
    halfLength: Double,
): Body {
    val colour = palette.brick(build.colour)
    val top = RobotPlan3D.BRICK_TOP
    val outline = round.cutRectangle(-halfWidth, -halfLength, halfWidth, halfLength, RobotPlan3D.BRICK_CORNER)
    // The parts of the face keep their proportions on a face that is less long.
    val scale = halfLength / NXT_HALF_LENGTH

    fun plate(left: Double, lower: Double, right: Double, upper: Double, colour: Int) =
        Round.plate(left, lower * scale, right, upper * scale, top, colour)
    val ports = listOf(-1.75, 0.0, 1.75).map { plate(it - 0.5, 4.0, it + 0.5, 4.65, palette.chassis) } +
        listOf(-2.0, -0.67, 0.67, 2.0).map { plate(it - 0.45, -4.65, it + 0.45, -4.0, palette.chassis) }
    return prism(
        outline,
        RobotPlan3D.CHASSIS_TOP,
        top,
        colour,
        topDecals = listOf(
            plate(-2.75, -4.75, 2.75, 4.75, palette.nxtFace),
            plate(-2.4, 0.55, 2.4, 3.75, palette.bumperEdge),
            plate(-2.05, 0.9, 2.05, 3.4, palette.glass),
            plate(-0.75, -1.5, 0.75, 0.0, palette.orange),
            round.disc(-1.65, -0.75 * scale, top, 0.55, palette.bumper),
            round.disc(1.65, -0.75 * scale, top, 0.55, palette.bumper),
            plate(-1.3, -2.75, 1.3, -1.85, palette.bumperEdge),
        ) + ports,
    )
}

/** A hub around the origin: a light face in a frame of the robot's colour, with its display, if any, and its button. */
private fun hubBody(
    kind: BrickKind,
    build: RobotPlacement,
    palette: RobotPalette,
    round: Round,
    halfWidth: Double,
    halfLength: Double,
): Body {
    val top = RobotPlan3D.BRICK_TOP
    val outline = round.cutRectangle(-halfWidth, -halfLength, halfWidth, halfLength, RobotPlan3D.BRICK_CORNER)
    val face = Round.plate(
        HUB_FRAME - halfWidth,
        HUB_FRAME - halfLength,
        halfWidth - HUB_FRAME,
        halfLength - HUB_FRAME,
        top,
        palette.nxtFace,
    )
    val glass = Round.plate(
        -halfWidth * HUB_SHARE,
        -halfLength * HUB_RISE,
        halfWidth * HUB_SHARE,
        halfLength * HUB_SHARE,
        top,
        palette.glass,
    )
    val button = round.disc(0.0, -halfLength * HUB_SHARE, top, HUB_BUTTON, palette.bumper)
    val decals = listOfNotNull(face, glass.takeIf { kind.displayRows > 0 }, button)
    return prism(outline, RobotPlan3D.CHASSIS_TOP, top, palette.brick(build.colour), topDecals = decals)
}

/** A micro:bit around the origin: a dark board in a frame of the robot's colour, with its lights, buttons and pins. */
private fun microbitBody(
    build: RobotPlacement,
    palette: RobotPalette,
    round: Round,
    halfWidth: Double,
    halfLength: Double,
): Body {
    val top = RobotPlan3D.BRICK_TOP
    val outline = round.cutRectangle(-halfWidth, -halfLength, halfWidth, halfLength, RobotPlan3D.BRICK_CORNER)
    val board = Round.plate(
        BOARD_FRAME - halfWidth,
        BOARD_FRAME - halfLength,
        halfWidth - BOARD_FRAME,
        halfLength - BOARD_FRAME,
        top,
        palette.chassis,
    )
    val lights = List(LIGHTS * LIGHTS) { place ->
        val x = (place % LIGHTS - LIGHTS / 2) * LIGHT_STEP
        val y = (place / LIGHTS - LIGHTS / 2) * LIGHT_STEP + LIGHTS_UP
        Round.plate(x - LIGHT, y - LIGHT, x + LIGHT, y + LIGHT, top, palette.sensorLamp)
    }
    val buttons = listOf(-1, 1).map {
        round.disc(it * halfWidth * BOARD_SIDE, LIGHTS_UP, top, BOARD_BUTTON, palette.bumper)
    }
    val pins = List(LIGHTS) {
        round.disc((it - LIGHTS / 2) * PIN_STEP, PINS_DOWN - halfLength, top, BOARD_PIN, palette.orange)
    }
    return prism(
        outline,
        RobotPlan3D.CHASSIS_TOP,
        top,
        palette.brick(build.colour),
        topDecals = listOf(board) + lights + buttons + pins,
    )
}

private const val BOARD_FRAME = 0.15
private const val BOARD_SIDE = 0.72
private const val BOARD_BUTTON = 0.32
private const val BOARD_PIN = 0.22
private const val LIGHTS = 5
private const val LIGHT = 0.09
private const val LIGHT_STEP = 0.38
private const val LIGHTS_UP = 0.2
private const val PIN_STEP = 0.9
private const val PINS_DOWN = 0.45
private const val HUB_FRAME = 0.35
private const val HUB_SHARE = 0.6
private const val HUB_RISE = 0.2
private const val HUB_BUTTON = 0.6
private const val NXT_HALF_LENGTH = 5.1
