package robotran.simulation.messages

import robotran.simulation.state.GoalStatus
import robotran.world.TouchKind
import robotran.world.writeThousandths

/** What pupils are told to do, in one language: a sentence for each kind of goal, made from the goal's figures. */
interface GoalMessages {
    /** @param within a number of seconds, as everywhere here. */
    fun reach(who: Mover, region: Region, whole: Boolean, within: Int?, stays: Boolean): String

    fun stayOut(who: Mover, region: Region, whole: Boolean): String

    fun stayIn(who: Mover, region: Region, whole: Boolean): String

    /** @param what in the order of [TouchKind]; all of them for anything. */
    fun neverTouch(who: Mover, what: List<TouchKind>): String

    /**
     * @param tolerance in centimetres, written as a number.
     * @param coverage in percent.
     */
    fun drawTemplate(tolerance: String, coverage: Int): String

    /** In centimetres, written as numbers; one of the two is not null. */
    fun inkLength(atLeast: String?, atMost: String?): String

    /**
     * @param line the line's name; null if there is only one.
     * @param laps above 0; less than 1 for a part of the line.
     */
    fun followLine(who: Mover, line: String?, closed: Boolean, laps: Double, within: Int?): String

    fun endWithin(who: Mover, seconds: Int): String

    fun showOnDisplay(who: Mover, text: String): String

    /** @param lowest in hertz, as [highest]; either may be null. */
    fun playSound(who: Mover, times: Int, lowest: Int?, highest: Int?): String

    fun inOrder(): String

    fun all(): String

    fun anyOf(): String

    /** What became of a goal, in a word or two: see [wordFor]. */
    fun met(): String

    fun notMet(): String

    fun notYet(): String
}

/** How a goal stands, in a word or two; the same wherever it is told. */
fun GoalMessages.wordFor(status: GoalStatus): String = when (status) {
    GoalStatus.MET -> met()
    GoalStatus.FAILED -> notMet()
    GoalStatus.PENDING -> notYet()
}

/** As a person writes it, such as `1.5` or `20`. */
internal fun number(value: Double): String = writeThousandths(value).removeSuffix(".0")

/** Whom a goal is about, as a sentence names him. */
sealed interface Mover {
    /** The pupil's own robot. */
    data object OwnRobot : Mover

    data class OtherRobot(val name: String) : Mover

    data class Block(val name: String) : Mover
}

/**
 * A region as a sentence names it.
 *
 * @property name the name of the mark that covers just this region; null if there is none that has a name.
 * @property place where on the paper its middle is.
 */
data class Region(val name: String?, val place: PaperPlace)

/** A ninth of the paper. */
enum class PaperPlace { TOP_LEFT, TOP, TOP_RIGHT, LEFT, MIDDLE, RIGHT, BOTTOM_LEFT, BOTTOM, BOTTOM_RIGHT }
