package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.simulation.state.SessionState
import robotran.uikit.*

/**
 * What stands on the paper casts a shadow to the lower right, as from a window, below everything that casts one.
 * Several copies of the walls make a soft edge, which costs less than blurring; they are drawn once ([GroundPicture]).
 */
internal fun DrawScope.drawSolidShadows(drawing: SheetDrawing, colour: Color) {
    if (colour.alpha == 0f) return
    val far = solidShadow(drawing.transform)
    for (part in LAYERS) translate(far.x * part, far.y * part) { drawPath(drawing.solids.outline.path, colour) }
}

/** How far the shadow of a wall reaches, in pixels. */
internal fun solidShadow(transform: SheetTransform): Offset = LIGHT_WAY * (SOLID_HEIGHT * transform.pixelsPerCentimetre)

/** The shadows of blocks and robots, in every frame: one copy each, a little darker. */
internal fun DrawScope.drawMovingShadows(drawing: SheetDrawing, state: SessionState, shadow: Color) {
    if (shadow.alpha == 0f) return
    val colour = shadow.copy(alpha = shadow.alpha * SINGLE_COPY)
    val scale = drawing.transform.pixelsPerCentimetre
    val ofBlock = LIGHT_WAY * (BLOCK_HEIGHT * scale)
    val target = CanvasTarget(this)
    for ((block, moved) in drawing.blocks.zip(state.blocks)) {
        target.atBlock(block, moved, drawing.transform, ofBlock) { shape(block.outline, colour) }
    }
    for ((plan, robot) in drawing.robots.zip(state.robots)) {
        val pose = robot.robot.pose
        val place = drawing.transform.toPixels(pose.x, pose.y) + LIGHT_WAY * (ROBOT_HEIGHT * scale)
        withTransform({
            translate(place.x, place.y)
            rotate(-pose.heading.toFloat(), Offset.Zero)
            scale(scale, scale, Offset.Zero)
        }) { drawPath(plan.outline, colour) }
    }
}

/** Away from the light, in centimetres for each centimetre of height. */
private val LIGHT_WAY = Offset(0.3f, 0.42f)

/** The parts of a shadow's length at which its copies lie. */
private val LAYERS = listOf(1f, 0.75f, 0.5f)

/** How much darker than one of several copies a single one is. */
private const val SINGLE_COPY = 1.6f

/** In centimetres: a low light would hide what is drawn beside a wall. */
private const val SOLID_HEIGHT = 2.4f
private const val BLOCK_HEIGHT = 1.4f
private const val ROBOT_HEIGHT = 1.8f
