package robotran.ui.brick.hub

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.hub.model.HubButton
import robotran.hub.model.HubModel
import robotran.ui.brick.front.ButtonFinish
import robotran.ui.brick.front.ButtonShape
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontShape
import robotran.ui.brick.front.PortForm
import robotran.ui.brick.front.PortLook
import robotran.ui.brick.front.StripLook
import robotran.ui.brick.nxt.NxtColours
import robotran.ui.texts.HubTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/**
 * The front of a hub: its lights or screen, its buttons, and its ports above and below, with plugs and buttons large
 * enough for fingers. The ports of a hub with letters lie as on one that is turned to the right: A, C and E above.
 */
internal class HubPlan(private val model: HubModel) {
    private val rim = if (model.kind.hasLetteredInputs) HubColours.RIM else HubColours.GREY_RIM

    val front = FrontPlan(
        body(),
        ButtonFinish(corner = 14f, side = 0.3f, pressed = 0.14f, isSquashed = true),
        ports(isAbove = true) + FrontPart.Display(GLASS) + buttons() + ports(isAbove = false),
        StripLook(
            HubColours.CASE,
            HubColours.EDGE,
            buttonSize = DpSize(56.dp, 52.dp),
            lowButtonSize = DpSize(52.dp, 48.dp),
            gap = 8.dp,
        ),
    )

    private fun body(): List<FrontShape> = listOf(
        FrontShape(FrontShape.Box(BODY, CORNER), HubColours.EDGE),
        FrontShape(FrontShape.Box(BODY.deflate(1.5f), CORNER), rim),
        FrontShape(FrontShape.Box(CASE, CORNER), HubColours.CASE),
    ) + if (model.hasMatrix || model.hasScreen) {
        listOf(FrontShape(FrontShape.Box(GLASS.inflate(FRAME), FRAME), HubColours.FRAME))
    } else {
        emptyList()
    }

    private fun buttons(): List<FrontPart> = model.buttons.map { button ->
        val look = LOOKS.getValue(button)
        FrontPart.Button(
            button.control,
            look.place,
            look.name,
            look.colours.first,
            look.colours.second,
            text = "",
            shape = look.shape,
        )
    }

    /** On a hub with letters each port is for motors and sensors; on others motors are above, sensors below. */
    private fun ports(isAbove: Boolean): List<FrontPart> {
        val isLettered = model.kind.hasLetteredInputs
        val all = if (isAbove && !isLettered) model.motorPorts else model.sensorPorts
        val shown = if (isLettered) all.indices.filter { (it % 2 == 0) == isAbove } else all.indices.toList()
        val width = minOf(MOST_WIDTH, (FrontPlan.WIDTH - SPACE) / shown.size - SPACE)
        val first = (FrontPlan.WIDTH - shown.size * (width + SPACE) + SPACE) / 2
        return shown.mapIndexed { number, index ->
            val left = first + number * (width + SPACE)
            val place = if (isAbove) {
                Rect(left, 0f, left + width, HEIGHT)
            } else {
                Rect(left, FrontPlan.HEIGHT - HEIGHT, left + width, FrontPlan.HEIGHT)
            }
            when {
                isAbove && !isLettered -> FrontPart.Output(place, look(isAbove), index)
                else -> FrontPart.Input(place, look(isAbove), index)
            }
        }
    }

    private fun look(isAbove: Boolean) = PortLook(
        PortForm.Plug(
            isAbove,
            NxtColours.PLUG_EDGE,
            latch = NxtColours.LABEL.copy(alpha = 0.28f),
            holeEdge = NxtColours.EDGE,
            hole = NxtColours.SOCKET,
        ),
        NxtColours.PLUG,
        NxtColours.DRIVEN,
        ink = NxtColours.ON_PLUG,
        litInk = NxtColours.LABEL,
    )

    private class ButtonLook(
        val place: Rect,
        val name: Label,
        val colours: Pair<Color, Color>,
        val shape: ButtonShape = ButtonShape.PLATE,
    )

    private companion object {
        const val CORNER = 20f
        const val FRAME = 6f
        const val HEIGHT = 63f
        const val MOST_WIDTH = 78f
        const val SPACE = 7f
        val BODY = Rect(4f, 34f, 260f, 391f)
        val CASE = Rect(16f, 46f, 248f, 379f)
        val GLASS = Rect(62f, 78f, 202f, 204f)
        val PLAIN = HubColours.BUTTON to HubColours.ON_BUTTON
        val MIDDLE = HubColours.MIDDLE to HubColours.ON_MIDDLE
        val LOOKS = mapOf(
            HubButton.LEFT to
                ButtonLook(Rect(30f, 238f, 94f, 290f), NxtTexts::left, PLAIN, ButtonShape.TO_THE_LEFT),
            HubButton.CENTER to ButtonLook(Rect(102f, 238f, 162f, 290f), HubTexts::middle, MIDDLE),
            HubButton.RIGHT to
                ButtonLook(Rect(170f, 238f, 234f, 290f), NxtTexts::right, PLAIN, ButtonShape.TO_THE_RIGHT),
            HubButton.BLUETOOTH to ButtonLook(Rect(184f, 302f, 236f, 354f), HubTexts::bluetooth, PLAIN),
            HubButton.UP to ButtonLook(Rect(184f, 302f, 236f, 354f), HubTexts::up, PLAIN),
            HubButton.DOWN to ButtonLook(Rect(106f, 302f, 158f, 354f), HubTexts::down, PLAIN),
            HubButton.BACK to ButtonLook(Rect(28f, 302f, 80f, 354f), HubTexts::back, MIDDLE),
        )
    }
}
