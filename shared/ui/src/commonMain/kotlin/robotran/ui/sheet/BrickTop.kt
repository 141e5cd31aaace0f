package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.brick.kind.BrickKind
import robotran.world.RobotDescription
import robotran.world.robot.brickSeat

/**
 * The brick on a robot, from above, see [brickSeat].
 *
 * @param middle its middle on the robot.
 * @param quarters its quarter turns clockwise from having its upper end to the left.
 */
internal class BrickTop(val kind: BrickKind, private val middle: Offset, private val quarters: Int) {
    val box: Rect = rect(bodyOf(kind))
    val display: Rect = rect(if (kind == BrickKind.RCX) RCX_DISPLAY else NXT_GLASS)

    /** A place on the brick, whose upper end is at smaller y, on the robot. */
    fun rect(place: Rect): Rect = boxAround(cornersOf(place).map(::point))

    fun point(place: Offset): Offset = middle + when (quarters) {
        0 -> place
        1 -> Offset(-place.y, place.x)
        2 -> -place
        else -> Offset(place.y, -place.x)
    }

    companion object {
        /** An RCX is 6.4 by 11.2 cm. View and On-Off are behind the display if it lies across, Prgm and Run ahead. */
        private val RCX_BODY = Rect(-3.05f, -4.9f, 3.05f, 4.9f)
        private val RCX_DISPLAY = Rect(-0.95f, -1.5f, 1.05f, 1.5f)
        val RCX_BUTTONS: List<Offset> =
            listOf(Offset(-2.05f, -1.1f), Offset(-2.05f, 1.1f), Offset(1.95f, -1.1f), Offset(1.95f, 1.1f))
        val RCX_INPUTS: List<Rect> = rcxPortsAt(-3.6f)
        val RCX_OUTPUTS: List<Rect> = rcxPortsAt(3.6f)

        /** An NXT is 7.2 by 11.2 cm. */
        private val NXT_BODY = Rect(-3.3f, -5.1f, 3.3f, 5.1f)
        val NXT_FACE = Rect(-2.75f, -4.75f, 2.75f, 4.75f)
        val NXT_FRAME = Rect(-2.4f, -3.75f, 2.4f, -0.55f)
        val NXT_GLASS = Rect(-2.05f, -3.4f, 2.05f, -0.9f)
        val NXT_ENTER = Rect(-0.75f, 0f, 0.75f, 1.5f)
        val NXT_ARROWS: List<Offset> = listOf(Offset(-1.65f, 0.75f), Offset(1.65f, 0.75f))
        val NXT_ESCAPE = Rect(-1.3f, 1.85f, 1.3f, 2.75f)
        val NXT_MOTORS: List<Rect> = nxtPortsAt(-4.55f, listOf(-1.75f, 0f, 1.75f))
        val NXT_SENSORS: List<Rect> = nxtPortsAt(4.1f, listOf(-2f, -0.67f, 0.67f, 2f))

        fun of(robot: RobotDescription): BrickTop {
            val seat = robot.brickSeat
            return BrickTop(
                robot.brick,
                seat.middle.toPlan(),
                (ACROSS - seat.upperEnd + WHOLE_TURN) / ACROSS % QUARTERS,
            )
        }

        private const val ACROSS = 90
        private const val WHOLE_TURN = 360
        private const val QUARTERS = 4

        private fun bodyOf(kind: BrickKind): Rect = if (kind == BrickKind.RCX) RCX_BODY else NXT_BODY

        private fun rcxPortsAt(y: Float): List<Rect> = listOf(-1.85f, 0.05f, 1.95f).map {
            Rect(it - 0.7f, y - 0.7f, it + 0.7f, y + 0.7f)
        }

        private fun nxtPortsAt(y: Float, middles: List<Float>): List<Rect> = middles.map {
            Rect(it - 0.5f, y - 0.1f, it + 0.5f, y + 0.6f)
        }
    }
}
