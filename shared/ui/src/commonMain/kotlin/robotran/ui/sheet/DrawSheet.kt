package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.workshop.state.SheetLayer

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
        if (grain == null || !drawing.ground.draw(this, colours, grain, isStretched)) {
            drawGround(drawing, colours, grain, visible)
        }
        if (SheetLayer.GRID in shown) drawGrid(drawing.transform)
        if (SheetLayer.GOALS in
            shown
        ) {
            for (region in drawing.regions) drawRegion(region, state.goals, drawing.transform, labels)
        }
        drawInk(drawing.ink, state.ink, drawing.world.robots, visible)
        if (SheetLayer.TRAIL in shown) drawTrail(drawing.trail, state.trail, drawing.world.robots, visible)
        drawGlow(drawing.glow, state)
        if (SheetLayer.SENSORS in shown) drawSights(drawing.world, state, drawing.transform)
        drawMovingShadows(drawing, state, colours.shadow)
        drawSolids(drawing.solids)
        for ((block, pose) in drawing.blocks.zip(state.blocks)) drawBlock(block, pose, drawing.transform)
        drawing.world.robots.zip(state.robots).forEachIndexed { number, (place, robot) ->
            drawRobot(robot.robot, place, drawing.transform, penbotFace(state, number, isStill))
        }
        drawLamps(drawing.world, state, drawing.transform)
    }
    if (labels == null) return
    if (SheetLayer.GRID in shown) drawGridFigures(drawing.world.paper, view, colours, labels)
    if (SheetLayer.NAMES in shown) drawElementNames(drawing.world, state, view, labels)
    if (SheetLayer.NAMES in shown || state.robots.size > 1) drawRobotNames(drawing.world.robots, state, view, labels)
    if (SheetLayer.SENSORS in shown) drawReadings(drawing.world, state, view, labels)
}

/** Draws in the coordinates of [drawing] and transforms the result to [view]. [draw] receives the visible part. */
private inline fun DrawScope.inView(drawing: SheetDrawing, view: SheetTransform, draw: DrawScope.(Rect) -> Unit) {
    val larger = view.pixelsPerCentimetre / drawing.transform.pixelsPerCentimetre
    if (!larger.isFinite()) return
    val move = view.paper.topLeft - drawing.transform.paper.topLeft * larger
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
    drawOnPaper(drawing)
    drawSolidShadows(drawing, colours.shadow)
}

private fun DrawScope.drawOnPaper(drawing: SheetDrawing) {
    val paper = drawing.transform.paper
    clipRect(paper.left, paper.top, paper.right, paper.bottom) { for (mark in drawing.marks) drawMark(mark) }
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
    drawOnPaper(drawing)
    drawRect(colours.paperEdge, transform.paper.topLeft, transform.paper.size, style = Stroke(1f))
    if (SheetLayer.GRID in shown) drawGrid(transform)
    if (SheetLayer.GOALS in shown) {
        for (region in drawing.regions) drawRegion(region, state.goals, transform, labels = null, withFlag = false)
    }
    drawInk(drawing.ink, state.ink, drawing.world.robots, visible)
    if (SheetLayer.TRAIL in shown) drawTrail(drawing.trail, state.trail, drawing.world.robots, visible)
    val paper = transform.paper
    clipRect(paper.left, paper.top, paper.right, paper.bottom) { drawStandingGlow(drawing.glow, state) }
}

private fun DrawScope.drawPaper(colours: SheetColours, paper: Rect, grain: ImageBitmap?, visible: Rect) {
    // Only the edge of the shadow is drawn: the paper covers the rest.
    val edge = colours.shadow.copy(alpha = colours.shadow.alpha * LAYER)
    for (width in PAPER_SHADOW) {
        val shift = Offset(0f, width.toPx() / 2)
        drawRect(edge, paper.topLeft + shift, paper.size, style = Stroke(2 * width.toPx()))
    }
    if (grain == null) drawRect(colours.paper, paper.topLeft, paper.size) else drawGrain(grain, paper, visible)
    drawRect(colours.paperEdge, paper.topLeft, paper.size, style = Stroke(1f))
}

/** How far the layers of its shadow reach beyond the paper. */
private val PAPER_SHADOW = listOf(1.dp, 2.5.dp, 5.dp)

/** The strength of one layer: paper lies flat. */
private const val LAYER = 0.7f
