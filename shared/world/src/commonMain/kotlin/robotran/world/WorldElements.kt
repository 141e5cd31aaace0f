package robotran.world

import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/**
 * A straight wall that stops robots. It covers everything within half its [thickness] of the line, with square ends
 * that extend as far beyond [from] and [to], so that walls with a common end make a closed corner. In centimetres.
 */
data class Wall(val from: Point, val to: Point, val thickness: Double, val unknown: UnknownFields = UnknownFields.NONE)

/**
 * An immovable object that stops robots and light.
 *
 * @property name null if it has none.
 */
data class Barrier(val shape: Shape, val name: String? = null, val unknown: UnknownFields = UnknownFields.NONE)

/**
 * An object that a robot can push.
 *
 * @property mass in kilograms.
 * @property friction Coulomb coefficient between it and the paper: cardboard slides at about 0.3, rubber at 1.
 */
data class MovableBlock(
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

/** A print or painting on the paper that a light sensor can detect; it is no obstacle. */
data class Mark(
    val figure: MarkFigure,
    val shade: Shade = Shade.Grey(0.0),
    val name: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
)

/** The figure of a [Mark]. */
sealed interface MarkFigure {
    /** A filled area. */
    data class Area(val shape: Shape) : MarkFigure

    /**
     * A line with round bends and ends.
     *
     * @property points two or more.
     * @property closed whether it continues from the last point to the first.
     */
    data class Line(val points: List<Point>, val width: Double, val closed: Boolean = false) : MarkFigure

    /**
     * An image of square cells; its own greys replace the mark's shade.
     *
     * @property corner its lower left corner.
     * @property cell the side of a cell.
     * @property rows from the top down, all of the same length; one hexadecimal digit per cell, `0` black, `f` white,
     * `.` transparent.
     */
    data class GreyMap(val corner: Point, val cell: Double, val rows: List<String>) : MarkFigure
}

/** The lightness of a mark. */
sealed interface Shade {
    /** The part of the light sensor's light that it reflects, 0..1. */
    val reflectance: Double

    /** From 0, black, to 1, white. */
    data class Grey(override val reflectance: Double) : Shade

    /**
     * A colour with components 0..255. The sensor's lamp is red, so red objects look nearly white to it and blue ones
     * dark. The weights are those of a red LED and a sensor that sees little green and almost no blue.
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
 * A lamp above the paper; robots can drive under it.
 *
 * @property brightness in the units of [Light]: 1 is a bedside lamp, 4 a good torch.
 * @property direction of the centre of its cone.
 * @property cone the angle of its cone; 360 if it shines all round.
 * @property on whether it is on at the start of a session.
 * @property infrared whether it sends infrared light, which nobody sees but infrared seekers.
 */
data class Lamp(
    val place: Point,
    val brightness: Double = 1.0,
    val direction: Double = 0.0,
    val cone: Double = ALL_ROUND,
    val on: Boolean = true,
    val name: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
    val infrared: Boolean = false,
) {
    companion object {
        const val ALL_ROUND = 360.0
    }
}
