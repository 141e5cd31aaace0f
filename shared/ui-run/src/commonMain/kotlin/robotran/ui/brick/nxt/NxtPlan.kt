package robotran.ui.brick.nxt

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort

/**
 * The layout of an NXT's front, on a plan of [WIDTH] by [HEIGHT] units. Arranged as on a real one, which is 7.2 by 11.2
 * centimetres, but with larger plugs and buttons for fingers. The plan is as large as that of an RCX, so that either
 * fits into the same places of the screen.
 */
internal object NxtPlan {
    const val WIDTH = 264f
    const val HEIGHT = 424f

    const val CORNER = 20f
    val BODY = Rect(4f, 34f, 260f, 391f)

    /** The light front between the two grey beams at the sides. */
    val FACE = Rect(19f, 34f, 245f, 391f)

    /** The x centres of the beams, and the y centres of their holes. */
    val BEAMS = listOf(11.5f, 252.5f)
    val BEAM_HOLES = List(13) { 78f + it * 22.2f }
    const val HOLE_RADIUS = 4.6f

    /** The dark frame around the glass, and the most that the glass can have of it. */
    val FRAME = Rect(19f, 69f, 245f, 218f)
    val GLASS = Rect(23f, 73f, 241f, 214f)

    const val BUTTON_CORNER = 10f
    val ENTER = Rect(104f, 227f, 160f, 283f)
    val ESCAPE = Rect(82f, 295f, 182f, 347f)
    val BUTTONS: Map<BrickButton, Rect> = mapOf(
        BrickButton.LEFT to Rect(30f, 227f, 94f, 283f),
        BrickButton.ENTER to ENTER,
        BrickButton.RIGHT to Rect(170f, 227f, 234f, 283f),
        BrickButton.ESCAPE to ESCAPE,
    )

    /** The slots in front of the loudspeaker. */
    val SPEAKER: List<Rect> = List(5) { Rect(36f, 302f + it * 9f, 68f, 305.5f + it * 9f) }

    /** Lit while it sends by radio. */
    val RADIO_LAMP = Offset(212f, 309f)
    const val RADIO_LAMP_RADIUS = 5f

    /** Plugs of the motors A to C on top and of the sensors 1 to 4 at the bottom, with an end of their cables. */
    val MOTORS: Map<MotorPort, Rect> = MotorPort.entries.associateWith {
        val left = 7.5f + it.ordinal * 85.5f
        Rect(left, 0f, left + 78f, 63f)
    }
    val SENSORS: List<Rect> = List(4) {
        val left = 6.4f + it * 64.4f
        Rect(left, 361f, left + 58f, 424f)
    }

    /** The visible end of a cable. */
    const val CABLE_LENGTH = 7f
    const val CABLE_WIDTH = 22f
    const val PLUG_CORNER = 7f
}
