package robotran.ui.brick.microbit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.microbit.model.MicrobitButton
import robotran.microbit.model.MicrobitModel
import robotran.ui.brick.front.ButtonFinish
import robotran.ui.brick.front.ButtonShape
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontShape
import robotran.ui.brick.front.FrontSide
import robotran.ui.brick.front.StripLook
import robotran.ui.brick.plug.portLook
import robotran.ui.brick.plug.rowOf
import robotran.ui.texts.MicrobitTexts
import robotran.uikit.*

/**
 * A micro:bit plugged into its buggy, seen from the front: lights, buttons, the golden logo of a V2 and the pins, and below
 * the buggy with its wheels and the eyes of its distance sensor.
 */
internal fun microbitPlan(model: MicrobitModel): FrontPlan {
    val outputs = rowOf(model.kind.motorPorts.size, FrontSide.ABOVE, MOST_WIDTH)
    val inputs = rowOf(model.kind.inputPorts, FrontSide.BELOW, MOST_WIDTH)
    return FrontPlan(
        buggy() + board(),
        ButtonFinish(corner = 12f, side = 0.3f, pressed = 0.2f, isSquashed = true),
        outputs.mapIndexed { index, place -> FrontPart.Output(place, portLook(FrontSide.ABOVE), index) } +
            FrontPart.Display(LIGHTS) +
            model.buttons.map(::buttonOf) +
            inputs.mapIndexed { index, place -> FrontPart.Input(place, portLook(FrontSide.BELOW), index) },
        StripLook(
            MicrobitColours.STRIP,
            MicrobitColours.STRIP_EDGE,
            buttonSize = DpSize(56.dp, 52.dp),
            lowButtonSize = DpSize(52.dp, 48.dp),
            gap = 8.dp,
        ),
    )
}

private fun board(): List<FrontShape> = listOf(
    box(BOARD, 16f, MicrobitColours.BOARD_EDGE),
    box(BOARD.deflate(1.5f), 15f, MicrobitColours.BOARD),
    box(Rect(BOARD.left + 1.5f, PINS_TOP, BOARD.right - 1.5f, BOARD.bottom - 1.5f), 4f, MicrobitColours.BOARD_EDGE),
) + List(LARGE_PINS) { BOARD.left + PIN_EDGE + it * PIN_STEP }.flatMap { middle ->
    listOf(
        box(Rect(middle - PIN, PINS_TOP + 2f, middle + PIN, BOARD.bottom - 2f), 3f, MicrobitColours.GOLD),
        FrontShape(FrontShape.Disc(Offset(middle, PINS_TOP + PIN), HOLE), MicrobitColours.HOLE),
    )
} + List(LARGE_PINS - 1) { BOARD.left + PIN_EDGE + (it + 0.5f) * PIN_STEP }.flatMap { middle ->
    listOf(-1, 1).map { side ->
        val x = middle + side * SMALL_STEP
        box(Rect(x - SMALL, PINS_TOP + SMALL_TOP, x + SMALL, BOARD.bottom - 2f), 1f, MicrobitColours.GOLD)
    }
}

private fun buggy(): List<FrontShape> =
    listOf(Rect(2f, 258f, 34f, 386f), Rect(230f, 258f, 262f, 386f)).flatMap { tyre ->
        listOf(box(tyre, 10f, MicrobitColours.TYRE)) + List(TREADS) {
            val y = tyre.top + TREAD_STEP * (it + 1)
            FrontShape(
                FrontShape.Line(Offset(tyre.left + 5f, y), Offset(tyre.right - 5f, y), 3f),
                MicrobitColours.TREAD,
            )
        }
    } + listOf(
        box(BUGGY, 22f, MicrobitColours.BUGGY_EDGE),
        box(BUGGY.deflate(1.5f), 21f, MicrobitColours.BUGGY),
        box(
            Rect(BOARD.left - 4f, BOARD.bottom - 14f, BOARD.right + 4f, BOARD.bottom + 12f),
            5f,
            MicrobitColours.SOCKET,
        ),
    ) + listOf(EYE_LEFT, EYE_RIGHT).flatMap { x ->
        listOf(
            FrontShape(FrontShape.Disc(Offset(x, EYE_Y), EYE), MicrobitColours.SONAR),
            FrontShape(FrontShape.Disc(Offset(x, EYE_Y), EYE - 5f), MicrobitColours.SONAR_DARK),
        )
    }

private fun buttonOf(button: MicrobitButton): FrontPart.Button = when (button) {
    MicrobitButton.A -> knob(button, Rect(31f, 138f, 85f, 192f), MicrobitTexts::buttonA, "A")
    MicrobitButton.B -> knob(button, Rect(179f, 138f, 233f, 192f), MicrobitTexts::buttonB, "B")

    MicrobitButton.LOGO -> FrontPart.Button(
        button.control,
        Rect(98f, 74f, 166f, 126f),
        MicrobitTexts::logo,
        MicrobitColours.GOLD,
        MicrobitColours.ON_GOLD,
        textSize = 14f,
    )
}

private fun knob(button: MicrobitButton, place: Rect, name: Label, text: String) = FrontPart.Button(
    button.control,
    place,
    name,
    MicrobitColours.METAL,
    MicrobitColours.ON_METAL,
    text,
    textSize = 22f,
    ButtonShape.ROUND,
)

private fun box(bounds: Rect, corner: Float, colour: Color) = FrontShape(FrontShape.Box(bounds, corner), colour)

private val BOARD = Rect(22f, 68f, 242f, 262f)
private val BUGGY = Rect(26f, 240f, 238f, 392f)
private val LIGHTS = Rect(92f, 132f, 172f, 212f)
private const val MOST_WIDTH = 78f

/** The five large pins: 0, 1, 2, 3V and GND, and the small ones between. */
private const val LARGE_PINS = 5
private const val PINS_TOP = 222f
private const val PIN_EDGE = 26f
private const val PIN_STEP = 42f
private const val PIN = 11f
private const val HOLE = 6f
private const val SMALL = 2f
private const val SMALL_STEP = 4f
private const val SMALL_TOP = 14f
private const val TREADS = 7
private const val TREAD_STEP = 16f
private const val EYE_LEFT = 92f
private const val EYE_RIGHT = 172f
private const val EYE_Y = 316f
private const val EYE = 30f
