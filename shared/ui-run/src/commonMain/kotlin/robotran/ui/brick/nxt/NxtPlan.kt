package robotran.ui.brick.nxt

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.ui.brick.front.ButtonFinish
import robotran.ui.brick.front.ButtonShape
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontShape
import robotran.ui.brick.front.FrontSide
import robotran.ui.brick.front.PortForm
import robotran.ui.brick.front.PortLook
import robotran.ui.brick.front.Signal
import robotran.ui.brick.front.StripLook
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/**
 * The front of an NXT, arranged as on a real one, which is 7.2 by 11.2 centimetres, but with larger plugs and buttons for
 * fingers.
 */
internal object NxtPlan {
    private const val CORNER = 20f
    private val BODY = Rect(4f, 34f, 260f, 391f)

    /** The light front between the two grey beams at the sides. */
    private val FACE = Rect(19f, 34f, 245f, 391f)

    /** The x centres of the beams, and the y centres of their holes. */
    private val BEAMS = listOf(11.5f, 252.5f)
    private val BEAM_HOLES = List(13) { 78f + it * 22.2f }
    private const val HOLE_RADIUS = 4.6f

    /** The dark frame around the glass, and the most that the glass can have of it. */
    val FRAME = Rect(19f, 69f, 245f, 218f)
    private val GLASS = Rect(23f, 73f, 241f, 214f)

    /** The slots in front of the loudspeaker. */
    val SPEAKER: List<Rect> = List(5) { Rect(36f, 302f + it * 9f, 68f, 305.5f + it * 9f) }

    /** Lit while it sends by radio. */
    private val RADIO_LAMP = Offset(212f, 309f)
    private const val RADIO_LAMP_RADIUS = 5f

    private val sensor = PortLook(
        plug(FrontSide.BELOW),
        NxtColours.SENSOR_PLUG,
        NxtColours.READ,
        ink = NxtColours.LABEL,
        litInk = NxtColours.LABEL,
        emptyInk = NxtColours.ON_PLUG,
    )
    private val motor = PortLook(
        plug(FrontSide.ABOVE),
        NxtColours.PLUG,
        NxtColours.DRIVEN,
        ink = NxtColours.ON_PLUG,
        litInk = NxtColours.LABEL,
    )

    val front = FrontPlan(
        body(),
        ButtonFinish(corner = 10f, side = 0.4f, pressed = 0.14f, isSquashed = true),
        motors() + FrontPart.Display(GLASS) + buttons() + sensors(),
        StripLook(
            NxtColours.FACE,
            NxtColours.EDGE,
            buttonSize = DpSize(56.dp, 52.dp),
            lowButtonSize = DpSize(52.dp, 48.dp),
            gap = 8.dp,
        ),
    )

    /**
     * The grey case: beams with holes at the sides, the light face with the frame of the display, the loudspeaker and a
     * lamp.
     */
    private fun body(): List<FrontShape> = buildList {
        add(FrontShape(FrontShape.Box(BODY, CORNER), NxtColours.EDGE))
        add(FrontShape(FrontShape.Box(BODY.deflate(1.5f).translate(0f, -1f), CORNER), NxtColours.BEAM))
        val sides = listOf(FACE.left, FACE.right).map { x ->
            FrontShape(FrontShape.Line(Offset(x, BODY.top), Offset(x, BODY.bottom), 1.5f), NxtColours.FACE_EDGE)
        }
        val face = listOf(FrontShape(FrontShape.Box(FACE), NxtColours.FACE)) + sides
        add(FrontShape(FrontShape.Inside(FrontShape.Box(BODY.deflate(1.5f), CORNER), face), NxtColours.FACE))
        for (x in BEAMS) {
            for (y in BEAM_HOLES) {
                add(FrontShape(FrontShape.Disc(Offset(x, y), HOLE_RADIUS), NxtColours.BEAM_HOLE))
                add(FrontShape(FrontShape.Disc(Offset(x, y), HOLE_RADIUS, line = 1f), NxtColours.EDGE))
            }
        }
        add(FrontShape(FrontShape.Box(FRAME, 8f), NxtColours.FRAME))
        for (slot in SPEAKER) {
            add(FrontShape(FrontShape.Box(slot, 2f), NxtColours.SPEAKER, Signal.SOUNDING, NxtColours.SPEAKING))
        }
        addAll(waves())
        val lamp = FrontShape.Disc(RADIO_LAMP, RADIO_LAMP_RADIUS)
        add(FrontShape(lamp, NxtColours.FACE_EDGE, Signal.SENDING, NxtColours.RADIO))
    }

    /** Two arcs beside the loudspeaker, while it sounds. */
    private fun waves(): List<FrontShape> = listOf(6f, 11f).map { radius ->
        val middle = SPEAKER[SPEAKER.size / 2].centerLeft
        FrontShape(FrontShape.Arc(middle, radius, 130f, 100f, 2f), null, Signal.SOUNDING, NxtColours.SPEAKING)
    }

    private fun buttons(): List<FrontPart> {
        val arrow = NxtColours.ARROW to NxtColours.ON_ARROW
        val enter = NxtColours.ENTER to NxtColours.ON_ENTER
        val escape = NxtColours.ESCAPE to NxtColours.ON_ESCAPE
        return listOf(
            button(BrickButton.LEFT, Rect(30f, 227f, 94f, 283f), NxtTexts::left, arrow, ButtonShape.TO_THE_LEFT),
            button(BrickButton.ENTER, Rect(104f, 227f, 160f, 283f), NxtTexts::enter, enter),
            button(BrickButton.RIGHT, Rect(170f, 227f, 234f, 283f), NxtTexts::right, arrow, ButtonShape.TO_THE_RIGHT),
            button(BrickButton.ESCAPE, Rect(82f, 295f, 182f, 347f), NxtTexts::escape, escape),
        )
    }

    private fun button(
        button: BrickButton,
        place: Rect,
        name: Label,
        colours: Pair<Color, Color>,
        shape: ButtonShape = ButtonShape.PLATE,
    ) = FrontPart.Button(button, place, name, colours.first, colours.second, button.name, shape = shape)

    /** Plugs of the motors A to C on top, with an end of their cables. */
    private fun motors(): List<FrontPart> = List(3) {
        val left = 7.5f + it * 85.5f
        FrontPart.Output(Rect(left, 0f, left + 78f, 63f), motor, it)
    }

    /** The same of the sensors 1 to 4 at the bottom. */
    private fun sensors(): List<FrontPart> = List(4) {
        val left = 6.4f + it * 64.4f
        FrontPart.Input(Rect(left, 361f, left + 58f, 424f), sensor, it)
    }

    private fun plug(side: FrontSide) = PortForm.Plug(
        side,
        NxtColours.PLUG_EDGE,
        latch = NxtColours.LABEL.copy(alpha = 0.28f),
        holeEdge = NxtColours.EDGE,
        hole = NxtColours.SOCKET,
    )
}
