package robotran.world

import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/**
 * A straight wall that stops the robot: everything within half its [thickness] of the line, with square ends that reach
 * as far beyond [from] and [to], so that walls that share an end make a closed corner. In centimetres.
 */
data class Wall(val from: Point, val to: Point, val thickness: Double, val unknown: UnknownFields = UnknownFields.NONE)

/**
 * Something that stops robots and light and never moves.
 *
 * @property name what goals and people know it by; null if it has none.
 */
data class Barrier(val shape: Shape, val name: String? = null, val unknown: UnknownFields = UnknownFields.NONE)

/**
 * Something that a robot can push about.
 *
 * @property mass in kilograms.
 * @property friction Coulomb coefficient between it and the paper: cardboard slides at about 0.3, rubber at 1.
 */
data class Block(
    val shape: Shape,
    val mass: Double = DEFAULT_MASS,
    val friction: Double = DEFAULT_FRICTION,
    val name: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    companion object {
        /** A small cardboard box with something in it. */
        const val DEFAULT_MASS = 0.1
        const val DEFAULT_FRICTION = 0.3
    }
}

/** Something printed or painted on the paper that a light sensor can tell from it; it stops nobody. */
data class Mark(
    val figure: MarkFigure,
    val shade: Shade = Shade.Grey(0.0),
    val name: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
)

/** What a [Mark] looks like. */
sealed interface MarkFigure {
    /** A filled area. */
    data class Area(val shape: Shape) : MarkFigure

    /**
     * A line with round bends and ends.
     *
     * @property points two or more.
     * @property closed whether it goes on from the last point to the first.
     */
    data class Line(val points: List<Point>, val width: Double, val closed: Boolean = false) : MarkFigure

    /**
     * A picture of square cells; its own greys count, not the mark's shade.
     *
     * @property corner its lower left corner.
     * @property cell the side of a cell.
     * @property rows from the top down, all of the same length; a hexadecimal digit for each cell, `0` black, `f`
     * white, `.` nothing there.
     */
    data class GreyMap(val corner: Point, val cell: Double, val rows: List<String>) : MarkFigure
}

/** How light or dark something is. */
sealed interface Shade {
    /** How much of the light sensor's light comes back, 0..1. */
    val reflectance: Double

    /** From 0, black, to 1, white. */
    data class Grey(override val reflectance: Double) : Shade

    /**
     * A colour, each part 0..255. The sensor's lamp is red, so red things look nearly white to it and blue ones dark:
     * the weights are those of a red light-emitting diode seen by a sensor that sees little green and almost no blue.
     */
    data class Colour(val red: Int, val green: Int, val blue: Int) : Shade {
        override val reflectance: Double get() = (RED_WEIGHT * red + GREEN_WEIGHT * green + BLUE_WEIGHT * blue) / WHITE
    }

    private companion object {
        const val RED_WEIGHT = 70
        const val GREEN_WEIGHT = 25
        const val BLUE_WEIGHT = 5
        const val WHITE = 25_500.0
    }
}

/**
 * A lamp that stands on the paper; robots can drive under it.
 *
 * @property brightness in the units of [Light]: 1 is a bedside lamp, 4 a good torch.
 * @property direction where the middle of its cone shines to.
 * @property cone the angle of its cone; 360 if it shines all round.
 * @property on whether it shines when a session begins.
 */
data class Lamp(
    val place: Point,
    val brightness: Double = 1.0,
    val direction: Double = 0.0,
    val cone: Double = ALL_ROUND,
    val on: Boolean = true,
    val name: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    companion object {
        const val ALL_ROUND = 360.0
    }
}
