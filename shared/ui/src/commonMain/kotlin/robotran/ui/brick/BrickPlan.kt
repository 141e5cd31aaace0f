package robotran.ui.brick

import androidx.compose.ui.geometry.Rect
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.controls.MotorPort

/**
 * Where everything is on the brick's face, on a plan of [WIDTH] by [HEIGHT] units, measured on an RCX and widened where
 * a finger must fit.
 */
internal object BrickPlan {
    const val WIDTH = 264f
    const val HEIGHT = 424f

    /**
     * A button is 52 units high; the brick must not be drawn smaller than this share of a dp a unit, or fingers miss
     * it.
     */
    const val MIN_UNIT = 48f / 52f

    const val CORNER = 18f
    val INFRARED_WINDOW = Rect(72f, 14f, 192f, 50f)

    /** The middles of the two lamps behind the window, from the left. */
    val INFRARED_LAMPS = listOf(112f, 152f)
    val FACE = Rect(8f, 138f, 256f, 290f)
    val DISPLAY = Rect(72f, 177.5f, 192f, 250.5f)
    const val BUTTON_CORNER = 16f

    val BUTTONS: Map<BrickButton, Rect> = mapOf(
        BrickButton.VIEW to Rect(13f, 156f, 66f, 208f),
        BrickButton.ON_OFF to Rect(13f, 220f, 66f, 272f),
        BrickButton.PRGM to Rect(198f, 156f, 251f, 208f),
        BrickButton.RUN to Rect(198f, 220f, 251f, 272f),
    )

    /** The grey input ports, 1 first. */
    val INPUTS: List<Rect> = List(3) { portAt(it, 72f) }

    val OUTPUTS: Map<MotorPort, Rect> = MotorPort.entries.associateWith { portAt(it.ordinal, 304f) }

    private const val PORT_SIZE = 54f

    private fun portAt(column: Int, top: Float): Rect {
        val left = 29f + column * 76f
        return Rect(left, top, left + PORT_SIZE, top + PORT_SIZE)
    }

    const val STUD_RADIUS = 10f

    /** The middles of the studs that are not covered: beside the window and along the lower edge. */
    val STUDS: List<Pair<Float, Float>> =
        listOf(20.5f, 52.5f, 211.5f, 243.5f).map { it to 32f } + List(8) { 20.5f + it * 31.857f to 391f }
}
