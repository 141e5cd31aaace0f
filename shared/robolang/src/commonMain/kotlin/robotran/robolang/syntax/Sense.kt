package robotran.robolang.syntax

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.robolang.words.Keyword
import robotran.brick.controls.BrickButton as RealButton

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

/** The buttons of all bricks that programs can ask about. */
internal enum class BrickButton(val keyword: Keyword, private val real: RealButton) {
    RUN(Keyword.RUN, RealButton.RUN),
    VIEW(Keyword.VIEW, RealButton.VIEW),
    PRGM(Keyword.PRGM, RealButton.PRGM),
    ENTER(Keyword.ENTER, RealButton.ENTER),
    LEFT(Keyword.LEFT, RealButton.LEFT),
    RIGHT(Keyword.RIGHT, RealButton.RIGHT),
    ESCAPE(Keyword.ESCAPE, RealButton.ESCAPE),
    ;

    /** The first brick that has it. */
    val brick: BrickKind get() = BrickKind.entries.first { real in it.buttons }

    /** The button of [brick] for the same purpose; null if it has none. */
    fun on(brick: BrickKind): BrickButton? = among(of(brick))

    /** The one of [buttons] for the same purpose; null if none is. */
    fun among(buttons: Collection<BrickButton>): BrickButton? =
        listOfNotNull(this, COUNTERPARTS[this]).firstOrNull { it in buttons } ?: leftOf(buttons)

    /** Of a right button without a left one, the other one of the pair is that to enter, as on a micro:bit. */
    private fun leftOf(buttons: Collection<BrickButton>): BrickButton? =
        ENTER.takeIf { (this == LEFT || this == PRGM) && RIGHT in buttons && ENTER in buttons }

    companion object {
        private val PAIRS = listOf(RUN to ENTER, VIEW to RIGHT, PRGM to LEFT)
        private val COUNTERPARTS = (PAIRS + PAIRS.map { it.second to it.first }).toMap()

        fun of(brick: BrickKind): List<BrickButton> = entries.filter { it.real in brick.buttons }
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
