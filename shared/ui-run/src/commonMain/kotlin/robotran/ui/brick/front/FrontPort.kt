package robotran.ui.brick.front

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.uikit.*

/**
 * What a port shows now.
 *
 * @property name what is printed beside a real one.
 * @property description what a screen reader says.
 * @property lines what is written on it.
 * @property isPressed whether its touch sensor for fingers is pressed; null for any other sensor.
 */
internal class PortView(
    val name: String,
    val description: String,
    val lines: List<List<PortItem>>,
    val isLit: Boolean,
    val isPlugged: Boolean = true,
    val isPressed: Boolean? = null,
)

/** Something on a port; sizes are in units. */
internal sealed interface PortItem {
    class Words(val text: String, val size: Float = 16f) : PortItem

    /** @property draw fills the draw area, in the colour of what is written. */
    class Sign(val width: Float, val height: Float, val draw: DrawScope.(ink: Color) -> Unit) : PortItem
}

/**
 * A port of a brick, lit while it is in use.
 *
 * @param onTouch called when the user presses or releases the touch sensor for fingers; never called for others.
 */
@Composable
internal fun FrontPort(
    look: PortLook,
    view: PortView,
    unit: Dp,
    onTouch: (Boolean) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colour = if (view.isLit) look.lit else look.colour
    val ink = when {
        !view.isPlugged -> look.emptyInk
        view.isLit -> look.litInk
        else -> look.ink
    }
    val isPressed = view.isPressed
    Box(
        modifier
            .testTag(RunTags.port(view.name))
            .touchable(isPressed != null, onTouch)
            .clearAndSetSemantics {
                contentDescription = view.description
                if (isPressed != null) {
                    role = Role.Button
                    // An immediate release would be missed: one click presses it, the next releases it.
                    onClick {
                        onTouch(!isPressed)
                        true
                    }
                }
            }
            .drawBehind {
                when (look.form) {
                    is PortForm.Studs -> drawStuds(look.form, colour, unit.toPx())
                    is PortForm.Plug -> drawPlug(look.form, colour, view.isPlugged, unit.toPx())
                }
            },
        contentAlignment = Alignment.Center,
    ) {
        Column(Modifier.besideCable(look.form, unit), horizontalAlignment = Alignment.CenterHorizontally) {
            for (line in view.lines) {
                Row(
                    horizontalArrangement = Arrangement.spacedBy(unit * GAP),
                    verticalAlignment = Alignment.CenterVertically,
                ) { for (item in line) Item(item, ink, unit) }
            }
        }
    }
}

@Composable
private fun Modifier.touchable(isTouch: Boolean, onTouch: (Boolean) -> Unit): Modifier =
    if (isTouch) focusRing(12.dp).holdable({ onTouch(true) }, { onTouch(false) }) else this

private fun Modifier.besideCable(form: PortForm, unit: Dp): Modifier = when (form) {
    is PortForm.Studs -> this

    is PortForm.Plug -> {
        val cable = unit * CABLE_LENGTH
        when (form.side) {
            FrontSide.ABOVE -> padding(top = cable)
            FrontSide.BELOW -> padding(bottom = cable)
            FrontSide.LEFT -> padding(start = cable)
            FrontSide.RIGHT -> padding(end = cable)
        }
    }
}

@Composable
private fun Item(item: PortItem, ink: Color, unit: Dp) {
    when (item) {
        is PortItem.Sign -> Canvas(Modifier.size(unit * item.width, unit * item.height)) { item.draw(this, ink) }

        is PortItem.Words -> Text(
            item.text,
            style = TextStyles.scaled(unit, item.size, item.size + LEADING).copy(fontWeight = FontWeight.Bold),
            color = ink,
            maxLines = 1,
            softWrap = false,
        )
    }
}

/** Between things in a line, and what a line is higher than its letters, in units. */
private const val GAP = 4
private const val LEADING = 2f
