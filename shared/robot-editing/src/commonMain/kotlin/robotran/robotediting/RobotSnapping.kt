package robotran.robotediting

import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import kotlin.math.floor

/** The steps in which drags and keys move and turn. */
object RobotSnapping {
    const val CENTIMETRES = 0.5
    const val DEGREES = 15.0

    /** Twice as long figures, such as a track that one wheel is dragged for, snap to twice the step. */
    internal fun length(centimetres: Double, step: Double = CENTIMETRES): Double =
        floor(centimetres / step + HALF) * step

    internal fun place(point: Point) = Point(length(point.x), length(point.y))

    /** The step of [DEGREES] that is nearest to the direction of [x], [y]; the same on every platform. */
    internal fun angleTowards(x: Double, y: Double): Double = normalAngle(
        ANGLES.maxBy { angle -> Direction(angle).let { x * it.cosine + y * it.sine } },
    )

    private val ANGLES = List((FULL_TURN / DEGREES).toInt()) { it * DEGREES }

    private const val HALF = 0.5
}

/** In (-180, 180] degrees. */
internal fun normalAngle(degrees: Double): Double {
    val rest = degrees - FULL_TURN * floor(degrees / FULL_TURN)
    return if (rest > FULL_TURN / 2) rest - FULL_TURN else rest
}

private const val FULL_TURN = 360.0
