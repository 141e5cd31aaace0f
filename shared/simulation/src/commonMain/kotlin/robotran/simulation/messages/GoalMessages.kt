package robotran.simulation.messages

import robotran.simulation.state.GoalStatus
import robotran.world.TouchKind
import robotran.world.writeThousandths

/** The instructions for pupils in one language: a sentence for each kind of goal, generated from its values. */
interface GoalMessages {
    /** @param within a number of seconds, as in all functions here. */
    fun reach(who: Mover, region: Region, whole: Boolean, within: Int?, stays: Boolean): String

    fun stayOut(who: Mover, region: Region, whole: Boolean): String

    fun stayIn(who: Mover, region: Region, whole: Boolean): String

    /** @param what in the order of [TouchKind]; all kinds mean anything. */
    fun neverTouch(who: Mover, what: List<TouchKind>): String

    /**
     * @param tolerance in centimetres, formatted.
     * @param coverage in percent.
     */
    fun drawTemplate(tolerance: String, coverage: Int): String

    /** Formatted lengths in centimetres; at least one is not null. */
    fun inkLength(atLeast: String?, atMost: String?): String

    /**
     * @param line the line's name; null if there is only one.
     * @param laps above 0; less than 1 for a part of the line.
     */
    fun followLine(who: Mover, line: String?, closed: Boolean, laps: Double, within: Int?): String

    fun endWithin(who: Mover, seconds: Int): String

    fun showOnDisplay(who: Mover, text: String, stays: Boolean): String

    /**
     * @param times how many exactly; null if one or more will do.
     * @param lowest in hertz, like [highest]; either may be null.
     */
    fun playSound(who: Mover, times: Int?, lowest: Int?, highest: Int?): String

    fun inOrder(): String

    fun all(): String

    fun anyOf(): String

    /** The status of a goal, in a word or two: see [wordFor]. */
    fun met(): String

    fun notMet(): String

    fun notYet(): String
}

/** The status of a goal, in a word or two; used everywhere. */
fun GoalMessages.wordFor(status: GoalStatus): String = when (status) {
    GoalStatus.MET -> met()
    GoalStatus.FAILED -> notMet()
    GoalStatus.PENDING -> notYet()
}

/** The number as people write it, such as `1.5` or `20`. */
internal fun number(value: Double): String = writeThousandths(value).removeSuffix(".0")

/** The robot or object of a goal, as a sentence names it. */
sealed interface Mover {
    /** The pupil's own robot. */
    data object OwnRobot : Mover

    data class OtherRobot(val name: String) : Mover

    data class Block(val name: String) : Mover
}

/**
 * A region as a sentence names it.
 *
 * @property name the name of the mark that covers exactly this region; null if there is none with a name.
 * @property place the part of the paper that contains its centre.
 */
data class Region(val name: String?, val place: PaperSector)

/** A ninth of the paper. */
enum class PaperSector { TOP_LEFT, TOP, TOP_RIGHT, LEFT, MIDDLE, RIGHT, BOTTOM_LEFT, BOTTOM, BOTTOM_RIGHT }
