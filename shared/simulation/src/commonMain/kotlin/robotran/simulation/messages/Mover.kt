package robotran.simulation.messages

import robotran.simulation.state.GoalStatus
import robotran.world.writeThousandths

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
