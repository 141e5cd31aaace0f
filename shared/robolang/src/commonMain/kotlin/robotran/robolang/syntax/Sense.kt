package robotran.robolang.syntax

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.robolang.words.Keyword

/** The sensors of the robot, and other readings of the brick. */
internal sealed interface Sense {
    /** `left bumper`. */
    data object LeftBumper : Sense

    /** `right bumper`. */
    data object RightBumper : Sense

    /** `light`, 0..100. */
    data object Light : Sense

    /** `sensor 1`: the canonical value on [port] 1..4; a colour if a colour sensor of an NXT is there. */
    data class Sensor(val port: Int) : Sense

    /** `button run`: whether it is held down. */
    data class Button(val button: BrickButton) : Sense

    /** `timer`, in seconds since the start or the last `reset timer`. */
    data object Timer : Sense

    /** `battery`, in volts. */
    data object Battery : Sense

    /** `distance` to what the ultrasonic sensor hears, in centimetres; 255 if it hears nothing. */
    data object Distance : Sense

    /** `loudness`, 0..100. */
    data object Loudness : Sense

    /** `colour` under the colour sensor. */
    data object Colour : Sense

    /** `turned A`: degrees that a motor has turned since the start or the last `reset motor A`. */
    data class Turned(val port: MotorPort) : Sense
}

/** The buttons of both bricks. A program for an NXT may also use the names of the RCX's buttons. */
internal enum class BrickButton(val keyword: Keyword, val kind: BrickKind) {
    RUN(Keyword.RUN, BrickKind.RCX),
    VIEW(Keyword.VIEW, BrickKind.RCX),
    PRGM(Keyword.PRGM, BrickKind.RCX),
    ENTER(Keyword.ENTER, BrickKind.NXT),
    LEFT(Keyword.LEFT, BrickKind.NXT),
    RIGHT(Keyword.RIGHT, BrickKind.NXT),
    ESCAPE(Keyword.ESCAPE, BrickKind.NXT),
    ;

    /** The button of [wanted] for the same purpose; null if it has none. */
    fun on(wanted: BrickKind): BrickButton? = if (kind == wanted) this else COUNTERPARTS[this]

    companion object {
        private val PAIRS = listOf(RUN to ENTER, VIEW to RIGHT, PRGM to LEFT)
        private val COUNTERPARTS = (PAIRS + PAIRS.map { it.second to it.first }).toMap()

        fun of(kind: BrickKind): List<BrickButton> = entries.filter { it.kind == kind }
    }
}

/**
 * The colours that a colour sensor tells apart.
 *
 * @property number its number in leJOS NXJ's class Color.
 */
internal enum class PaintColour(val keyword: Keyword, val number: Int) {
    BLACK(Keyword.BLACK, 7),
    BLUE(Keyword.BLUE, 2),
    GREEN(Keyword.GREEN, 1),
    YELLOW(Keyword.YELLOW, 3),
    RED(Keyword.RED, 0),
    WHITE(Keyword.WHITE, 6),
}
