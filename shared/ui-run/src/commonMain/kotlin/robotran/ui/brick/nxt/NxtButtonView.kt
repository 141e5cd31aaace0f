package robotran.ui.brick.nxt

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.offset
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.RoundRect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.lerp
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import robotran.brick.controls.BrickButton
import robotran.ui.run.tags.RunTags
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/** A button of an NXT, drawn pressed while [down]. A click by a screen reader presses and releases it. */
@Composable
internal fun NxtButtonView(
    button: BrickButton,
    unit: Dp,
    down: Boolean,
    onPress: () -> Unit,
    onRelease: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val look = look(button)
    val name = look.name(spoken)
    val colour = if (down) lerp(look.colour, RobotranColours.SHADE, PRESSED) else look.colour
    val edge = lerp(look.colour, RobotranColours.SHADE, SIDE)
    Box(
        modifier
            .testTag(RunTags.button(button))
            .focusRing(unit * NxtPlan.BUTTON_CORNER)
            .holdable(onPress, onRelease)
            .semantics {
                role = Role.Button
                contentDescription = name
                onClick(name) {
                    onPress()
                    onRelease()
                    true
                }
            }
            .drawBehind {
                val shape = shapeOf(button, size, unit.toPx() * NxtPlan.BUTTON_CORNER)
                drawNxtButton(shape, colour, edge, unit.toPx() * SUNK, down)
                look.arrow?.let { drawArrow(it, look.label, if (down) unit.toPx() * SUNK else 0f) }
            },
        contentAlignment = Alignment.Center,
    ) {
        if (look.arrow == null) {
            Text(
                look.text,
                Modifier.offset(y = unit * if (down) SUNK / 2 else -SUNK / 2).clearAndSetSemantics { },
                TextStyles.scaled(unit, LABEL_SIZE).strong,
                color = look.label,
                maxLines = 1,
                softWrap = false,
            )
        }
    }
}

/** The arrow buttons are cut to points, the others are plates. */
private fun shapeOf(button: BrickButton, size: Size, corner: Float): Path = Path().apply {
    val (width, height) = size
    when (button) {
        BrickButton.LEFT -> pointed(width, height, corner, isLeft = true)
        BrickButton.RIGHT -> pointed(width, height, corner, isLeft = false)
        else -> addRoundRect(RoundRect(Rect(Offset.Zero, size), CornerRadius(corner)))
    }
}

/** A plate whose outer side narrows. */
private fun Path.pointed(width: Float, height: Float, corner: Float, isLeft: Boolean) {
    fun x(share: Float) = if (isLeft) share * width else (1 - share) * width
    val cut = corner / width
    moveTo(x(1f - cut), 0f)
    lineTo(x(POINT), 0f)
    quadraticTo(x(POINT * 0.6f), 0f, x(POINT * 0.45f), height * 0.12f)
    lineTo(x(0.02f), height * 0.42f)
    quadraticTo(x(-0.02f), height * 0.5f, x(0.02f), height * 0.58f)
    lineTo(x(POINT * 0.45f), height * 0.88f)
    quadraticTo(x(POINT * 0.6f), height, x(POINT), height)
    lineTo(x(1f - cut), height)
    quadraticTo(x(1f), height, x(1f), height - corner)
    lineTo(x(1f), corner)
    quadraticTo(x(1f), 0f, x(1f - cut), 0f)
    close()
}

private fun DrawScope.drawArrow(towards: Float, colour: Color, sunk: Float) {
    val middle = Offset(size.width * (0.5f + towards * 0.02f), (size.height - SUNK) / 2 + sunk / 2)
    val half = size.height * ARROW_SIZE
    val arrow = Path().apply {
        moveTo(middle.x + towards * half, middle.y)
        lineTo(middle.x - towards * half * 0.7f, middle.y - half)
        lineTo(middle.x - towards * half * 0.7f, middle.y + half)
        close()
    }
    drawPath(arrow, colour)
}

/**
 * @property arrow -1 for one to the left, 1 for one to the right; null for a button with [text].
 */
private class NxtButtonLook(
    val name: Label,
    val colour: Color,
    val label: Color,
    val text: String = "",
    val arrow: Float? = null,
)

private fun look(button: BrickButton): NxtButtonLook = when (button) {
    BrickButton.ENTER -> NxtButtonLook(NxtTexts::enter, NxtColours.ENTER, NxtColours.ON_ENTER, "ENTER")
    BrickButton.LEFT -> NxtButtonLook(NxtTexts::left, NxtColours.ARROW, NxtColours.ON_ARROW, arrow = -1f)
    BrickButton.RIGHT -> NxtButtonLook(NxtTexts::right, NxtColours.ARROW, NxtColours.ON_ARROW, arrow = 1f)
    BrickButton.ESCAPE -> NxtButtonLook(NxtTexts::escape, NxtColours.ESCAPE, NxtColours.ON_ESCAPE, "ESCAPE")
    else -> error("An NXT has no $button.")
}

/** In units of the [NxtPlan]. */
private const val SUNK = 4f
private const val LABEL_SIZE = 12.5f

/** Where the narrowing of an arrow button begins, and the size of its arrow, as shares of its size. */
private const val POINT = 0.34f
private const val ARROW_SIZE = 0.2f
private const val PRESSED = 0.14f
private const val SIDE = 0.4f
