package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Rect
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.uikit.*

/**
 * The layout of the brick's front, on a plan of [WIDTH] by [HEIGHT] units. Measured on an RCX, and wider where a finger
 * needs room.
 */
internal object BrickPlan {
    const val WIDTH = 264f
    const val HEIGHT = 424f

    /** The ratio of width to height. */
    const val ASPECT = WIDTH / HEIGHT

    /** The min dp per unit. A button is 52 units high and would otherwise be too small for a finger. */
    const val MIN_UNIT = 48f / 52f

    const val CORNER = 18f
    val INFRARED_WINDOW = Rect(72f, 14f, 192f, 50f)

    /** The x centres of the two infrared lamps behind the window, from the left. */
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

    /** The grey input ports, from 1. */
    val INPUTS: List<Rect> = List(3) { portAt(it, 72f) }

    val OUTPUTS: Map<MotorPort, Rect> = MotorPort.entries.associateWith { portAt(it.ordinal, 304f) }

    private const val PORT_SIZE = 54f

    private fun portAt(column: Int, top: Float): Rect {
        val left = 29f + column * 76f
        return Rect(left, top, left + PORT_SIZE, top + PORT_SIZE)
    }

    const val STUD_RADIUS = 10f

    /** The centres of the visible studs: beside the window and along the lower edge. */
    val STUDS: List<Pair<Float, Float>> =
        listOf(20.5f, 52.5f, 211.5f, 243.5f).map { it to 32f } + List(8) { 20.5f + it * 31.857f to 391f }
}
