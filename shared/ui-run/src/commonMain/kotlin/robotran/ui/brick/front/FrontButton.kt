package robotran.ui.brick.front

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.padding
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
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.graphics.lerp
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.uikit.*

/** A button of a brick, drawn pressed while [down]. A click by a screen reader presses and releases it. */
@Composable
internal fun FrontButton(
    part: FrontPart.Button,
    finish: ButtonFinish,
    unit: Dp,
    down: Boolean,
    onPress: () -> Unit,
    onRelease: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val name = part.name(spoken)
    Box(
        modifier
            .testTag(RunTags.button(part.button))
            .focusRing(unit * finish.corner)
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
            .drawBehind { drawButton(part, finish, unit, down) },
        contentAlignment = Alignment.Center,
    ) {
        if (part.shape.towards == null) {
            Text(
                part.text ?: name,
                Modifier.onTop(finish, unit, down).clearAndSetSemantics { },
                TextStyles.scaled(unit, part.textSize).strong,
                color = part.ink,
                maxLines = 1,
                softWrap = false,
            )
        }
    }
}

/** In the middle of its top, which sinks. */
private fun Modifier.onTop(finish: ButtonFinish, unit: Dp, down: Boolean): Modifier = if (finish.isSquashed) {
    offset(y = unit * if (down) SUNK / 2 else -SUNK / 2)
} else {
    offset(y = if (down) unit * SUNK else 0.dp).padding(bottom = unit * SUNK)
}

/** Its side and its top, which sinks. Fills the draw area. */
private fun DrawScope.drawButton(part: FrontPart.Button, finish: ButtonFinish, unit: Dp, down: Boolean) {
    val top = if (down) lerp(part.colour, RobotranColours.SHADE, finish.pressed) else part.colour
    val corner = (unit * finish.corner).toPx()
    val depth = if (finish.isSquashed) unit.toPx() * SUNK else (unit * SUNK).roundToPx().toFloat()
    val high = size.height - depth
    drawPath(pathOf(part.shape, size, corner), lerp(part.colour, RobotranColours.SHADE, finish.side))
    withTransform({
        translate(0f, if (down) depth else 0f)
        if (finish.isSquashed) scale(1f, high / size.height, Offset.Zero)
    }) { drawPath(pathOf(part.shape, if (finish.isSquashed) size else Size(size.width, high), corner), top) }
    part.shape.towards?.let { drawArrow(part.shape, it, part.ink, high / 2 + if (down) depth else 0f) }
}

private fun pathOf(shape: ButtonShape, size: Size, corner: Float): Path = Path().apply {
    when (shape) {
        ButtonShape.ROUND -> addOval(Rect(Offset.Zero, size))

        ButtonShape.PLATE, ButtonShape.UPWARDS, ButtonShape.DOWNWARDS -> {
            addRoundRect(RoundRect(Rect(Offset.Zero, size), CornerRadius(corner)))
        }

        ButtonShape.TO_THE_LEFT -> pointed(size.width, size.height, corner, isLeft = true)
        ButtonShape.TO_THE_RIGHT -> pointed(size.width, size.height, corner, isLeft = false)
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

private fun DrawScope.drawArrow(shape: ButtonShape, towards: Float, colour: Color, middleHeight: Float) {
    val half = size.height * ARROW_SIZE
    if (shape.isUpright) {
        val tip = middleHeight + towards * half * 0.85f
        val foot = middleHeight - towards * half * 0.85f
        val x = size.width / 2
        return drawPath(polygon(x, tip, x + half, foot, x - half, foot), colour)
    }
    val middle = Offset(size.width * (0.5f + towards * 0.02f), middleHeight)
    val base = middle.x - towards * half * 0.7f
    drawPath(polygon(middle.x + towards * half, middle.y, base, middle.y - half, base, middle.y + half), colour)
}

/** How far a pressed button sinks, in units. */
private const val SUNK = 4f

/** Where the narrowing of an arrow button begins, and the size of its arrow, as shares of its size. */
private const val POINT = 0.34f
private const val ARROW_SIZE = 0.2f
