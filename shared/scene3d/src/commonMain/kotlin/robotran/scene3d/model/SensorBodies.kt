package robotran.scene3d.model

import robotran.brick.sensors.SensorCase
import robotran.brick.sensors.SensorKind
import robotran.scene3d.geometry.ConvexPolygon

/** The bodies of sensors around their eyes, looking ahead. */
internal class SensorBodies(
    private val case: SensorCase,
    private val palette: RobotPalette,
    private val round: Round,
) {
    /** How far a high sensor reaches back, a negative number. */
    fun backOf(kind: SensorKind): Double = if (kind == SensorKind.ULTRASONIC) -1.8 else -2.0

    /** Half of the width of a high sensor. */
    fun halfOf(kind: SensorKind): Double = if (kind == SensorKind.ULTRASONIC) 2.3 else 1.2

    /** A small sensor near the floor, from [back] to [front], as wide as twice [half]. */
    fun low(back: Double, front: Double, half: Double): Body = prism(
        ConvexPolygon.rectangle(back, -half, front, half),
        LOWEST,
        RobotPlan3D.CHASSIS_BOTTOM,
        when (case) {
            SensorCase.STUDDED -> palette.lightSensor
            SensorCase.ROUNDED -> palette.nxtGrey
        },
    )

    /** A sensor that stands at the height [base], with its eyes on its front. */
    fun high(kind: SensorKind, back: Double, half: Double, base: Double): Body = prism(
        ConvexPolygon.rectangle(back, -half, 0.0, half),
        base,
        base + HEIGHT,
        palette.nxtGrey,
        shaded(palette.nxtGrey, LIT),
        sideDecals = { _, edge ->
            when {
                edge != FRONT -> emptyList()

                kind == SensorKind.ULTRASONIC -> listOf(-half / 2, half / 2).flatMap { y ->
                    listOf(
                        eye(y, base, half * EYE_PART, palette.chassis),
                        eye(y, base, half * LENS_PART, palette.orange),
                    )
                }

                else -> listOf(eye(0.0, base, half * MICROPHONE_PART, palette.chassis))
            }
        },
    )

    /** A disc on the front. */
    private fun eye(y: Double, base: Double, radius: Double, colour: Int): Decal {
        val ring = round.circle(y, base + HEIGHT / 2, radius, EYE_CORNERS)
        return Decal(
            DoubleArray(EYE_CORNERS * 3) { part ->
                when (part % 3) {
                    0 -> 0.0
                    1 -> ring.x(part / 3)
                    else -> ring.y(part / 3)
                }
            },
            colour,
            fine = false,
        )
    }

    companion object {
        const val LOW_HALF = 0.65
        private const val LOWEST = 0.35
        private const val HEIGHT = 2.3
        private const val FRONT = 1
        private const val EYE_CORNERS = 12
        private const val LIT = 1.04

        // Of half of the width.
        private const val EYE_PART = 0.38
        private const val LENS_PART = 0.2
        private const val MICROPHONE_PART = 0.6
    }
}
