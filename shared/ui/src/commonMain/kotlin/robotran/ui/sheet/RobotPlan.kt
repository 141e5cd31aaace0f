package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.world.Penbot

/**
 * The parts of the robot from above in centimetres: x forwards from the pen, which is halfway between the wheels, y to
 * its right.
 */
internal object RobotPlan {
    private val HALF_CHASSIS = (Penbot.CHASSIS_WIDTH / 2).toFloat()
    val CHASSIS = Rect(Penbot.CHASSIS_BACK.toFloat(), -HALF_CHASSIS, Penbot.CHASSIS_FRONT.toFloat(), HALF_CHASSIS)

    /** An RCX is 6.4 by 11.2 cm and lies across the chassis; slightly reduced to keep the tyres visible. */
    val BRICK = Rect(1.5f, -4.9f, 7.6f, 4.9f)
    val DISPLAY = Rect(3.6f, -1.5f, 5.6f, 1.5f)

    /**
     * The display lies along the robot: the brick's left is the robot's rear. View and On-Off are behind it, Prgm and
     * Run in front of it.
     */
    val BUTTONS: List<Offset> = listOf(Offset(2.5f, -1.1f), Offset(2.5f, 1.1f), Offset(6.5f, -1.1f), Offset(6.5f, 1.1f))
    val INPUTS: List<Rect> = portsAt(-3.6f)
    val OUTPUTS: List<Rect> = portsAt(3.6f)

    /** The motors of the two wheels, behind the axle. */
    val MOTORS: List<Rect> = listOf(Rect(-4.6f, -3.8f, -1.9f, -0.5f), Rect(-4.6f, 0.5f, -1.9f, 3.8f))
    val AXLE = Rect(-0.35f, -HALF_CHASSIS - 1f, 0.35f, HALF_CHASSIS + 1f)

    val WHEEL_MIDDLE = (Penbot.WHEEL_TRACK / 2).toFloat()
    val WHEEL_RADIUS = (Penbot.WHEEL_DIAMETER / 2).toFloat()
    val WHEEL_WIDTH = Penbot.WHEEL_WIDTH.toFloat()

    /** The number of treads around a tyre. */
    const val TREADS = 14

    private val BUMPER_BACK = Penbot.BUMPER_FRONT.toFloat() - 1f
    private val BUMPER_INNER = (Penbot.BUMPER_GAP / 2).toFloat()
    private val BUMPER_OUTER = BUMPER_INNER + Penbot.BUMPER_WIDTH.toFloat()
    val LEFT_BUMPER = Rect(BUMPER_BACK, -BUMPER_OUTER, Penbot.BUMPER_FRONT.toFloat(), -BUMPER_INNER)
    val RIGHT_BUMPER = Rect(BUMPER_BACK, BUMPER_INNER, Penbot.BUMPER_FRONT.toFloat(), BUMPER_OUTER)

    /** How far a bumper moves in on contact. */
    const val BUMPER_TRAVEL = 0.6f

    private val SENSOR = Penbot.LIGHT_SENSOR_POSITION.toFloat()
    val LIGHT_SENSOR = Rect(SENSOR - 0.4f, -0.8f, SENSOR + 0.8f, 0.8f)

    /** Two round tiles on the front edge of the brick, left and right of the light sensor. */
    val EYES: List<Offset> = listOf(Offset(7.3f, -2.25f), Offset(7.3f, 2.25f))
    const val EYE_RADIUS = 1.3f
    const val PUPIL_RADIUS = 0.66f

    /** How far a pupil moves from the middle of its eye. */
    const val GAZE = 0.5f

    val PEN = Offset.Zero
    const val PEN_RADIUS = 0.7f
    const val CLIP_RADIUS = 1.2f

    /** A lamp on top, above the display. */
    val BEACON: Offset = DISPLAY.center
    const val BEACON_RADIUS = 1.3f

    private fun portsAt(y: Float): List<Rect> = listOf(2.7f, 4.6f, 6.5f).map {
        Rect(
            it - 0.7f,
            y - 0.7f,
            it + 0.7f,
            y + 0.7f,
        )
    }
}
