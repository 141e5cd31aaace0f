package robotran.uikit

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.LocalContentColor
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Shape
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** A card, dialog or bar: a ground of its own with an edge. Touches do not reach what is below it. */
@Composable
fun Surface(
    modifier: Modifier = Modifier,
    shape: Shape = Shapes.MEDIUM,
    color: Color = LocalRobotranColours.current.pane,
    border: BorderStroke? = edge(),
    shadowElevation: Dp = 0.dp,
    content: @Composable () -> Unit,
) {
    val onIt = if (color == RobotranColours.YELLOW) RobotranColours.ON_YELLOW else LocalRobotranColours.current.onPane
    val elevation = with(LocalDensity.current) { shadowElevation.toPx() }
    val shadow = if (elevation > 0) {
        Modifier.graphicsLayer(shadowElevation = elevation, shape = shape, clip = false)
    } else {
        Modifier
    }
    CompositionLocalProvider(LocalContentColor provides onIt) {
        Box(
            modifier
                .then(shadow)
                .then(if (border == null) Modifier else Modifier.border(border, shape))
                .background(color, shape)
                .clip(shape)
                .semantics { isTraversalGroup = true }
                .pointerInput(Unit) { },
            propagateMinConstraints = true,
        ) { content() }
    }
}

/** A card that is a button; its content names it. */
@Composable
fun CardButton(
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    corner: Dp = Corners.MEDIUM,
    enabled: Boolean = true,
    color: Color = LocalRobotranColours.current.pane,
    border: BorderStroke? = edge(),
    content: @Composable () -> Unit,
) {
    val shape = RoundedCornerShape(corner)
    val press = Modifier.clickable(enabled, role = Role.Button, onClick = onClick)
    Surface(modifier.testTag(tag).focusRing(corner).clip(shape).then(press), shape, color, border, content = content)
}

/** The edge of a card or a control, by default as fine as between panes. */
@Composable
fun edge(color: Color = LocalRobotranColours.current.line, width: Dp = 1.dp): BorderStroke = BorderStroke(width, color)
