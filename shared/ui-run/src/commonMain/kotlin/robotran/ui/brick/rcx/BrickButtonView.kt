package robotran.ui.brick.rcx

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
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
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.ui.common.BrickColours
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*

/** A button of the brick, drawn pressed while [down]. A click by a screen reader presses and releases it. */
@Composable
internal fun BrickButtonView(
    button: BrickButton,
    unit: Dp,
    down: Boolean,
    onPress: () -> Unit,
    onRelease: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val look = look(button)
    val name = look.name(spoken)
    val corner = unit * BrickPlan.BUTTON_CORNER
    val shape = RoundedCornerShape(corner)
    Box(
        modifier
            .testTag(RunTags.button(button))
            .focusRing(corner)
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
            .background(lerp(look.colour, RobotranColours.SHADE, 0.45f), shape),
    ) {
        val sunk = if (down) unit * SUNK else 0.dp
        Box(
            Modifier
                .fillMaxSize()
                .offset(y = sunk)
                .padding(bottom = unit * SUNK)
                .background(if (down) lerp(look.colour, RobotranColours.SHADE, 0.12f) else look.colour, shape),
            contentAlignment = Alignment.Center,
        ) {
            Text(
                name,
                Modifier.clearAndSetSemantics { },
                TextStyles.scaled(unit, look.labelSize).strong,
                color = look.label,
                maxLines = 1,
                softWrap = false,
            )
        }
    }
}

/**
 * The depth of a pressed button and the font size of its label, in units of the [BrickPlan]. The longest label is
 * smaller to keep its margin.
 */
private const val SUNK = 4f
private const val LABEL_SIZE = 12.5f
private const val LONG_LABEL_SIZE = 10.5f

private class ButtonLook(val name: Label, val colour: Color, val label: Color, val labelSize: Float = LABEL_SIZE)

private fun look(button: BrickButton): ButtonLook = when (button) {
    BrickButton.VIEW -> ButtonLook(RunTexts::buttonView, BrickColours.VIEW, RobotranColours.ON_COLOUR)

    BrickButton.ON_OFF -> ButtonLook(
        RunTexts::buttonOnOff,
        RobotranColours.ON_OFF_RED,
        RobotranColours.ON_COLOUR,
        LONG_LABEL_SIZE,
    )

    BrickButton.PRGM -> ButtonLook(RunTexts::buttonPrgm, BrickColours.PRGM, BrickColours.LABEL)
    BrickButton.RUN -> ButtonLook(RunTexts::buttonRun, RobotranColours.RUN_GREEN, RobotranColours.ON_COLOUR)
    else -> error("An RCX has no $button.")
}
