package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.world.RobotDescription
import robotran.world.robot.brickSeat

/**
 * The brick on a robot, from above, see [brickSeat].
 *
 * @param middle its middle on the robot.
 * @param quarters its quarter turns clockwise from having its upper end to the left.
 */
class BrickTop(val look: BrickLook, private val middle: Offset, private val quarters: Int) {
    val box: Rect = rect(look.body)
    val display: Rect = rect(look.display)

    /** A place on the brick, whose upper end is at smaller y, on the robot. */
    fun rect(bounds: Rect): Rect = boxAround(cornersOf(bounds).map(::point))

    fun point(position: Offset): Offset = middle + when (quarters) {
        0 -> position
        1 -> Offset(-position.y, position.x)
        2 -> -position
        else -> Offset(position.y, -position.x)
    }

    companion object {
        fun of(robot: RobotDescription): BrickTop {
            val seat = robot.brickSeat
            return BrickTop(
                BrickLook.of(robot.brick),
                seat.middle.toPlan(),
                (ACROSS - seat.upperEnd + WHOLE_TURN) / ACROSS % QUARTERS,
            )
        }

        private const val ACROSS = 90
        private const val WHOLE_TURN = 360
        private const val QUARTERS = 4
    }
}
