package robotran.workshop.measuring

import androidx.compose.runtime.Immutable
import robotran.world.geometry.Point
import robotran.world.geometry.length
import robotran.world.geometry.normalHeading
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/**
 * A ruler on the sheet with a protractor at its start. It lies over the world and is no part of it.
 *
 * @property from where the ruler begins; the protractor lies around it.
 * @property to where the ruler ends.
 * @property base the direction from which the protractor counts.
 */
@Immutable
data class Measuring(val from: Point, val to: Point, val base: MeasuringBase) {
    /** The length of the ruler, for `forward`. */
    val centimetres: Double get() = length(to.x - from.x, to.y - from.y)

    /**
     * The angle for `turn`, in (-180, 180]: a robot at [from] that looks along [base] turns by as much to look at [to],
     * to the left if it is positive.
     */
    val degrees: Double get() = if (centimetres == 0.0) 0.0 else normalHeading(directionTo(to) - baseDirection)

    /** The direction of [base], in (-180, 180] degrees counter-clockwise from the x axis. */
    val baseDirection: Double
        get() = when (base) {
            is MeasuringBase.Heading -> base.degrees
            is MeasuringBase.Towards -> directionTo(base.point)
        }

    /** The place of [end]; a direction is held [BASE_CENTIMETRES] from [from]. */
    fun placeOf(end: MeasuringEnd): Point = when (end) {
        MeasuringEnd.FROM -> from
        MeasuringEnd.TO -> to

        MeasuringEnd.BASE -> when (base) {
            is MeasuringBase.Towards -> base.point
            is MeasuringBase.Heading -> ahead(from, base.degrees, BASE_CENTIMETRES)
        }
    }

    /** With [end] at [place]. The protractor counts from where a robot looks if it is put onto one. */
    fun moved(end: MeasuringEnd, place: SnappedPlace): Measuring = when (end) {
        MeasuringEnd.FROM -> copy(from = place.point, base = place.heading?.let(MeasuringBase::Heading) ?: base)
        MeasuringEnd.TO -> copy(to = place.point)
        MeasuringEnd.BASE -> copy(base = MeasuringBase.Towards(place.point))
    }

    private fun directionTo(point: Point): Double =
        normalHeading(atan2(point.y - from.y, point.x - from.x) * DEGREES_PER_RADIAN)

    companion object {
        /** How far from its middle the protractor is held by its base, in centimetres. */
        const val BASE_CENTIMETRES = 20.0
    }
}

/** The direction from which an angle counts. */
sealed interface MeasuringBase {
    /** Where a robot looks: [degrees] counter-clockwise from the x axis. */
    data class Heading(val degrees: Double) : MeasuringBase

    /** Towards [point], for the angle between three points. */
    data class Towards(val point: Point) : MeasuringBase
}

/** What a finger can hold of ruler and protractor. */
enum class MeasuringEnd { FROM, TO, BASE }

/** The point [centimetres] from [start] in the direction [heading]. */
internal fun ahead(start: Point, heading: Double, centimetres: Double): Point {
    val radians = heading / DEGREES_PER_RADIAN
    return Point(start.x + cos(radians) * centimetres, start.y + sin(radians) * centimetres)
}

private const val DEGREES_PER_RADIAN = 180 / PI
