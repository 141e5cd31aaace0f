package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.ui.brick.front.ButtonFinish
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontShape
import robotran.ui.brick.front.PortForm
import robotran.ui.brick.front.PortLook
import robotran.ui.brick.front.Signal
import robotran.ui.brick.front.StripLook
import robotran.ui.common.BrickColours
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*

/** The front of an RCX: measured on a real one, and wider where a finger needs room. */
internal object RcxPlan {
    val INFRARED_WINDOW = Rect(72f, 14f, 192f, 50f)

    /** The x centres of the two infrared lamps behind the window, from the left. */
    val INFRARED_LAMPS = listOf(112f, 152f)
    private const val CORNER = 18f
    private const val STUD_RADIUS = 10f

    /** The centres of the visible studs: beside the window and along the lower edge. */
    private val STUDS =
        listOf(20.5f, 52.5f, 211.5f, 243.5f).map { Offset(it, 32f) } + List(8) { Offset(20.5f + it * 31.857f, 391f) }

    private val studs = PortForm.Studs(BrickColours.EDGE)
    private val input =
        PortLook(studs, BrickColours.INPUT, BrickColours.READ, ink = BrickColours.LABEL, litInk = BrickColours.LABEL)
    private val output = PortLook(
        studs,
        BrickColours.OUTPUT,
        BrickColours.DRIVEN,
        ink = RobotranColours.ON_COLOUR,
        litInk = BrickColours.LABEL,
    )

    val front = FrontPlan(
        body(),
        ButtonFinish(corner = 16f, side = 0.45f, pressed = 0.12f, isSquashed = false),
        List(3) { FrontPart.Input(portAt(it, 72f), input, it) } + buttons() +
            FrontPart.Display(Rect(72f, 177.5f, 192f, 250.5f)) +
            List(3) { FrontPart.Output(portAt(it, 304f), output, it) },
        StripLook(
            RobotranColours.YELLOW,
            edge = null,
            buttonSize = DpSize(64.dp, 52.dp),
            lowButtonSize = DpSize(60.dp, 48.dp),
            gap = 12.dp,
        ),
    )

    /** The yellow case with its studs, the infrared window and the grey plate below the display and the buttons. */
    private fun body(): List<FrontShape> = buildList {
        val whole = Rect(0f, 0f, FrontPlan.WIDTH, FrontPlan.HEIGHT)
        add(FrontShape(FrontShape.Box(whole, CORNER), BrickColours.EDGE))
        add(FrontShape(FrontShape.Box(whole.deflate(2f).translate(0f, -1f), CORNER), RobotranColours.YELLOW))
        for (middle in STUDS) addAll(stud(middle))
        val window = FrontShape.Box(INFRARED_WINDOW, 10f)
        add(FrontShape(window, BrickColours.INFRARED, Signal.SENDING, BrickColours.INFRARED_SENDING))
        add(FrontShape(FrontShape.Box(Rect(80f, 20f, 184f, 30f), 5f), BrickColours.INFRARED_SHEEN))
        for (x in INFRARED_LAMPS) {
            add(FrontShape(FrontShape.Disc(Offset(x, 38f), 5f), null, Signal.SENDING, BrickColours.INFRARED_LAMP))
        }
        add(FrontShape(FrontShape.Box(Rect(8f, 138f, 256f, 290f), 14f), BrickColours.FACE))
    }

    private fun stud(middle: Offset): List<FrontShape> = listOf(
        FrontShape(FrontShape.Disc(middle + Offset(0f, 1.5f), STUD_RADIUS), BrickColours.EDGE),
        FrontShape(FrontShape.Disc(middle, STUD_RADIUS - 0.5f), BrickColours.STUD_LIGHT),
        FrontShape(FrontShape.Disc(middle, STUD_RADIUS - 2f), RobotranColours.YELLOW),
        FrontShape(FrontShape.Disc(middle, STUD_RADIUS - 0.5f, line = 1f), BrickColours.EDGE.copy(alpha = 0.35f)),
    )

    private fun buttons(): List<FrontPart> {
        val left = 13f
        val right = 198f
        val upper = 156f
        val lower = 220f
        return listOf(
            button(BrickButton.VIEW, left, upper, RunTexts::buttonView, BrickColours.VIEW),
            // The longest label is smaller to keep its margin.
            button(BrickButton.ON_OFF, left, lower, RunTexts::buttonOnOff, RobotranColours.ON_OFF_RED, size = 10.5f),
            button(BrickButton.PRGM, right, upper, RunTexts::buttonPrgm, BrickColours.PRGM, BrickColours.LABEL),
            button(BrickButton.RUN, right, lower, RunTexts::buttonRun, RobotranColours.RUN_GREEN),
        )
    }

    private fun button(
        button: BrickButton,
        x: Float,
        y: Float,
        name: Label,
        colour: Color,
        ink: Color = RobotranColours.ON_COLOUR,
        size: Float = 12.5f,
    ) = FrontPart.Button(button, Rect(x, y, x + 53f, y + 52f), name, colour, ink, textSize = size)

    private fun portAt(column: Int, top: Float): Rect {
        val left = 29f + column * 76f
        return Rect(left, top, left + 54f, top + 54f)
    }
}
