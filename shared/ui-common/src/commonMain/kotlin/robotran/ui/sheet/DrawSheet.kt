package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.uikit.*
import robotran.workshop.state.SheetLayer
import kotlin.math.round

/**
 * Draws the desk, the paper and everything on it; fills the draw area. Used by the screen and by exported pictures.
 *
 * @param labels measures the robots' names and the goals' numbers; null omits them.
 * @param shown the optional layers to draw.
 * @param view the position of the sheet if it differs from that of [drawing].
 * @param grain a tile of paper, see [paperGrain]; null for plain paper.
 * @param isStill whether the eyes of robots never move, as for less motion.
 */
fun DrawScope.drawSheet(
    drawing: SheetDrawing,
    state: SessionState,
    colours: SheetColours,
    labels: TextMeasurer? = null,
    shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    view: SheetTransform = drawing.transform,
    grain: ImageBitmap? = null,
    isStill: Boolean = false,
) {
    drawRect(colours.desk)
    inView(drawing, view) { visible ->
        val isStretched = view.pixelsPerCentimetre != drawing.transform.pixelsPerCentimetre
        if (grain == null) {
            drawGround(drawing, colours)
        } else {
            drawing.ground.draw(this, colours, grain, visible, isStretched)
        }
        if (SheetLayer.GRID in shown) drawGrid(drawing.transform)
        val target = CanvasTarget(this, labels)
        if (SheetLayer.GOALS in shown) {
            for (region in drawing.regions) target.drawRegion(region, state.goals, drawing.transform)
        }
        target.drawInk(drawing.ink, state.ink, drawing.world.robots, visible)
        if (SheetLayer.TRAIL in shown) drawTrail(drawing.trail, state.trail, drawing.world.robots, visible)
        target.drawGlow(drawing.glow, state)
        if (SheetLayer.SENSORS in shown) drawSights(drawing.world, state, drawing.transform)
        drawMovingShadows(drawing, state, colours.shadow)
        target.drawThings(drawing, state, isStill)
    }
    if (labels == null) return
    if (SheetLayer.GRID in shown) drawGridFigures(drawing.world.paper, view, colours, labels)
    if (SheetLayer.NAMES in shown) drawElementNames(drawing.world, state, view, labels)
    if (SheetLayer.NAMES in shown || state.robots.size > 1) drawRobotNames(drawing.world.robots, state, view, labels)
    if (SheetLayer.SENSORS in shown) drawReadings(drawing.world, state, view, labels)
}

/**
 * What stands on the paper.
 *
 * @param isStill whether the eyes of robots never move.
 */
internal fun DrawTarget.drawThings(drawing: SheetDrawing, state: SessionState, isStill: Boolean = false) {
    drawSolids(drawing.solids)
    for ((block, pose) in drawing.blocks.zip(state.blocks)) drawBlock(block, pose, drawing.transform)
    drawing.world.robots.zip(state.robots).forEachIndexed { number, (place, robot) ->
        val face = penbotFace(state, number, isStill, place.description.drive)
        drawRobot(robot.robot, place, drawing.robots[number], drawing.transform, face)
    }
    drawLamps(drawing.world, state, drawing.transform)
}

/** Draws in the coordinates of [drawing] and transforms the result to [view]. [draw] receives the visible part. */
private inline fun DrawScope.inView(drawing: SheetDrawing, view: SheetTransform, draw: DrawScope.(Rect) -> Unit) {
    val larger = view.pixelsPerCentimetre / drawing.transform.pixelsPerCentimetre
    if (!larger.isFinite()) return
    val exact = view.paper.topLeft - drawing.transform.paper.topLeft * larger
    // By whole pixels, so that the picture of the ground is sharp, and exactly below what is drawn over it.
    val move = if (larger == 1f) Offset(round(exact.x), round(exact.y)) else exact
    val visible = Rect(
        -move.x / larger,
        -move.y / larger,
        (size.width - move.x) / larger,
        (size.height - move.y) / larger,
    )
    withTransform({
        translate(move.x, move.y)
        scale(larger, larger, Offset.Zero)
    }) { draw(visible) }
}

/** The static background: paper, marks, the template, and the shadows of walls and barriers. */
internal fun DrawScope.drawGround(
    drawing: SheetDrawing,
    colours: SheetColours,
    grain: ImageBitmap? = null,
    visible: Rect = Rect(Offset.Zero, size),
) {
    drawPaper(colours, drawing.transform.paper, grain, visible)
    CanvasTarget(this).drawOnPaper(drawing)
    drawSolidShadows(drawing, colours.shadow)
}

/** Marks and the drawing to trace. */
internal fun DrawTarget.drawOnPaper(drawing: SheetDrawing) {
    inside(drawing.transform.paper) { for (mark in drawing.marks) drawMark(mark) }
    drawing.template?.let { drawTemplate(it, drawing.transform) }
}

/**
 * All that is flat on the paper, and the light of the lamps that stand, without any desk; for the 3D view.
 *
 * @param visible what of it is needed, in the pixels of [drawing].
 */
internal fun DrawScope.drawPaperLayer(
    drawing: SheetDrawing,
    state: SessionState,
    colours: SheetColours,
    shown: Set<SheetLayer>,
    visible: Rect,
) {
    val transform = drawing.transform
    drawRect(colours.paper, transform.paper.topLeft, transform.paper.size)
    val target = CanvasTarget(this)
    target.drawOnPaper(drawing)
    drawRect(colours.paperEdge, transform.paper.topLeft, transform.paper.size, style = Stroke(1f))
    if (SheetLayer.GRID in shown) drawGrid(transform)
    if (SheetLayer.GOALS in shown) {
        for (region in drawing.regions) target.drawRegion(region, state.goals, transform, withFlag = false)
    }
    target.drawInk(drawing.ink, state.ink, drawing.world.robots, visible)
    if (SheetLayer.TRAIL in shown) drawTrail(drawing.trail, state.trail, drawing.world.robots, visible)
    target.inside(transform.paper) { drawStandingGlow(drawing.glow, state) }
}

private fun DrawScope.drawPaper(colours: SheetColours, paper: Rect, grain: ImageBitmap?, visible: Rect) {
    // Only the edge of the shadow is drawn: the paper covers the rest.
    for ((width, strength) in PAPER_SHADOW) {
        val far = width.toPx()
        drawRect(
            colours.shadow.copy(alpha = colours.shadow.alpha * strength),
            paper.topLeft + Offset(far * AWAY, far * DOWN),
            paper.size,
            style = Stroke(2 * far),
        )
    }
    if (grain == null) drawRect(colours.paper, paper.topLeft, paper.size) else drawGrain(grain, paper, visible)
    drawRect(colours.paperEdge, paper.topLeft, paper.size, style = Stroke(1f))
}

/** How far the layers of its shadow reach beyond the paper, and their strength: paper lies flat. */
private val PAPER_SHADOW = listOf(1.dp to 0.8f, 2.dp to 0.6f, 3.dp to 0.45f, 4.dp to 0.3f, 5.dp to 0.2f)

/** How much of that is away from the light, which comes from the upper left. */
private const val AWAY = 0.5f
private const val DOWN = 0.8f
