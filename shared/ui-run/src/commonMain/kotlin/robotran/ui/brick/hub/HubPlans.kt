package robotran.ui.brick.hub

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import robotran.hub.model.HubButton
import robotran.hub.model.HubModel
import robotran.ui.brick.front.ButtonShape
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontShape
import robotran.ui.brick.front.FrontSide
import robotran.ui.brick.plug.portLook
import robotran.ui.brick.plug.rowOf
import robotran.ui.texts.HubTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/** SPIKE Prime: a flat light box with 5 by 5 lights, a round button in a ring of light, and three ports at each side. */
internal fun primePlan(model: HubModel): HubPlan {
    val body = Rect(26f, 3f, 238f, 421f)
    val matrix = Rect(81f, 90f, 183f, 192f)
    val middle = Rect(99f, 302f, 165f, 368f)
    val places = List(model.sensorPorts.size) { index ->
        val top = 78f + index / 2 * 68f
        if (index % 2 == 0) Rect(0f, top, 73f, top + 63f) else Rect(191f, top, 264f, top + 63f)
    }
    return HubPlan(
        caseOf(body, 26f) + listOf(
            FrontShape(FrontShape.Box(Rect(26f, 392f, 238f, 400f)), HubColours.YELLOW),
            FrontShape(FrontShape.Box(matrix.inflate(5f), 10f), HubColours.CASE_LINE),
            FrontShape(FrontShape.Box(matrix.inflate(3.5f), 10f), HubColours.MATRIX),
        ),
        matrix,
        listOf(
            button(HubButton.LEFT, Rect(38f, 307f, 92f, 363f), PLAIN, ButtonShape.TO_THE_LEFT),
            button(HubButton.CENTER, middle, HubColours.MIDDLE to HubColours.ON_BUTTON, ButtonShape.ROUND),
            button(HubButton.RIGHT, Rect(172f, 307f, 226f, 363f), PLAIN, ButtonShape.TO_THE_RIGHT),
            button(
                HubButton.BLUETOOTH,
                Rect(174f, 14f, 226f, 66f),
                HubColours.BLUETOOTH to HubColours.ON_DARK,
                ButtonShape.ROUND,
            ),
        ),
        places.mapIndexed { index, place ->
            FrontPart.Input(place, portLook(if (index % 2 == 0) FrontSide.LEFT else FrontSide.RIGHT), index)
        },
        ring = middle.center to 38f,
    )
}

/** EV3: a grey box with a screen, a cross of buttons, motors above and sensors below. */
internal fun ev3Plan(model: HubModel): HubPlan {
    val screen = Rect(40f, 66f, 224f, 182f)
    val middle = Rect(106f, 246f, 158f, 298f)
    val cross = mapOf(
        HubButton.UP to (Offset(0f, -54f) to ButtonShape.UPWARDS),
        HubButton.DOWN to (Offset(0f, 54f) to ButtonShape.DOWNWARDS),
        HubButton.LEFT to (Offset(-56f, 0f) to ButtonShape.TO_THE_LEFT),
        HubButton.RIGHT to (Offset(56f, 0f) to ButtonShape.TO_THE_RIGHT),
    ).map { (button, place) ->
        button(button, middle.translate(place.first), PLAIN, place.second)
    }
    val above = rowOf(model.motorPorts.size, FrontSide.ABOVE, MOST_WIDTH)
    val below = rowOf(model.sensorPorts.size, FrontSide.BELOW, MOST_WIDTH)
    return HubPlan(
        caseOf(Rect(4f, 34f, 260f, 391f), 18f) + listOf(
            FrontShape(FrontShape.Box(Rect(5.5f, 60f, 258.5f, 360f)), HubColours.GREY),
            FrontShape(FrontShape.Box(Rect(22f, 60f, 242f, 360f)), HubColours.CASE),
            FrontShape(FrontShape.Box(screen.inflate(6f), 6f), HubColours.FRAME),
        ),
        screen,
        cross + button(HubButton.CENTER, middle, DARK) +
            button(HubButton.BACK, Rect(30f, 191f, 84f, 243f), DARK, text = "✕"),
        above.mapIndexed { index, place -> FrontPart.Output(place, portLook(FrontSide.ABOVE), index) } +
            below.mapIndexed { index, place -> FrontPart.Input(place, portLook(FrontSide.BELOW), index) },
        ring = middle.center to 34f,
    )
}

/** A hub with one button and no display: a light box with its ports above and, if it has more than two, below. */
internal fun boxPlan(model: HubModel): HubPlan {
    val isSmall = model.sensorPorts.size <= 2
    val body = if (isSmall) Rect(44f, 34f, 220f, 330f) else Rect(24f, 34f, 240f, 391f)
    val middle = Rect(102f, 226f, 162f, 286f)
    val rows = model.sensorPorts.indices.chunked(2).zip(listOf(FrontSide.ABOVE, FrontSide.BELOW))
    return HubPlan(
        caseOf(body, 22f) +
            FrontShape(
                FrontShape.Box(Rect(body.left + 1.5f, 196f, body.right - 1.5f, 204f)),
                if (isSmall) HubColours.YELLOW else HubColours.GREY,
            ),
        Rect(body.left + 14f, 82f, body.right - 14f, 186f),
        listOf(button(HubButton.CENTER, middle, HubColours.GREEN to HubColours.ON_DARK, ButtonShape.ROUND)),
        rows.flatMap { (indices, side) ->
            indices.zip(rowOf(indices.size, side, MOST_WIDTH))
                .map { (index, place) -> FrontPart.Input(place, portLook(side), index) }
        },
        ring = middle.center to 37f,
    )
}

private fun button(
    button: HubButton,
    place: Rect,
    colours: Pair<Color, Color>,
    shape: ButtonShape = ButtonShape.PLATE,
    text: String = "",
) = FrontPart.Button(
    button.control,
    place,
    NAMES.getValue(button),
    colours.first,
    colours.second,
    text,
    textSize = 18f,
    shape,
)

private const val MOST_WIDTH = 78f
private val PLAIN = HubColours.BUTTON to HubColours.ON_BUTTON
private val DARK = HubColours.DARK to HubColours.ON_DARK
private val NAMES: Map<HubButton, Label> = mapOf(
    HubButton.LEFT to NxtTexts::left,
    HubButton.CENTER to HubTexts::middle,
    HubButton.RIGHT to NxtTexts::right,
    HubButton.BLUETOOTH to HubTexts::bluetooth,
    HubButton.UP to HubTexts::up,
    HubButton.DOWN to HubTexts::down,
    HubButton.BACK to HubTexts::back,
)
