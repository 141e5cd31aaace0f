package robotran.uikit

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.material3.IconButtonDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.material3.IconButton as MaterialIconButton

/** Where a button with an icon is, which is how it looks. */
enum class IconButtonKind(internal val size: Dp) {
    /** In a bar or card. */
    PLAIN(24.dp),

    /** In a card that tells of an error. */
    ERROR(24.dp),

    /** In a row of small controls. */
    SMALL(14.dp),

    /** In the tools above a program. */
    TOOL(16.dp),

    /** In what belongs to the run bar. */
    RUN(20.dp),

    /** Alone over a picture. */
    FLOATING(24.dp),
}

/**
 * A button with an [icon].
 *
 * @param name the action, for screen readers.
 * @param label a word beside the icon of a plain button, if there is room.
 */
@Composable
fun IconButton(
    icon: Icon,
    name: String,
    tag: String,
    kind: IconButtonKind = IconButtonKind.PLAIN,
    modifier: Modifier = Modifier,
    enabled: Boolean = true,
    label: String? = null,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    when (kind) {
        IconButtonKind.PLAIN -> PlainIconButton(icon, name, modifier.testTag(tag), colours.onPane, label, onClick)
        IconButtonKind.ERROR -> PlainIconButton(icon, name, modifier.testTag(tag), colours.error, label, onClick)

        IconButtonKind.FLOATING -> {
            val press = Modifier.clickable(enabled, role = Role.Button, onClick = onClick)
            val colour = if (enabled) colours.onPane else colours.line
            RoundIcon(icon, name, modifier.testTag(tag), colours.pane, colour, press)
        }

        IconButtonKind.SMALL, IconButtonKind.TOOL -> Box(
            modifier
                .testTag(tag)
                .size(Dimensions.TARGET)
                .clip(CircleShape)
                .focusRing()
                .clickable(enabled, role = Role.Button, onClick = onClick)
                .named(name),
            Alignment.Center,
        ) { IconView(icon, colours.onPane.let { if (enabled) it else it.copy(alpha = DISABLED) }, size = kind.size) }

        IconButtonKind.RUN -> MaterialIconButton(
            onClick,
            modifier.testTag(tag).named(name).focusRing().size(Dimensions.TARGET),
            enabled,
            IconButtonDefaults.iconButtonColors(
                contentColor = colours.onPane,
                disabledContentColor = colours.quiet.copy(alpha = QUIET),
            ),
        ) { IconView(icon, size = kind.size) }
    }
}

/** A button alone over a picture that switches something [on] and off. */
@Composable
fun IconSwitch(icon: Icon, name: String, tag: String, on: Boolean, onSwitch: () -> Unit) {
    val colours = LocalRobotranColours.current
    val press = Modifier.toggleable(on, role = Role.Switch) { onSwitch() }
    val ground = if (on) colours.onPane else colours.pane
    RoundIcon(icon, name, Modifier.testTag(tag), ground, if (on) colours.pane else colours.onPane, press)
}

@Composable
private fun PlainIconButton(
    icon: Icon,
    name: String,
    modifier: Modifier,
    colour: Color,
    label: String?,
    onClick: () -> Unit,
) = Row(
    modifier
        .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
        .focusRing()
        .clip(Shapes.MEDIUM)
        .clickable(role = Role.Button, onClick = onClick)
        .named(name)
        .padding(horizontal = if (label == null) 12.dp else 14.dp),
    Arrangement.spacedBy(8.dp, Alignment.CenterHorizontally),
    Alignment.CenterVertically,
) {
    IconView(icon, colour)
    if (label != null) Text(label, style = TextStyles.body.medium, color = colour, maxLines = 1)
}

@Composable
private fun RoundIcon(icon: Icon, name: String, modifier: Modifier, ground: Color, colour: Color, press: Modifier) =
    Box(
        modifier
            .size(Dimensions.TARGET)
            .focusRing(Dimensions.TARGET / 2)
            .clip(CircleShape)
            .background(ground)
            .border(1.dp, LocalRobotranColours.current.line, CircleShape)
            .then(press)
            .named(name),
        Alignment.Center,
    ) { IconView(icon, colour) }

/** Material's alpha of disabled elements. */
private const val DISABLED = 0.38f
private const val QUIET = 0.5f
