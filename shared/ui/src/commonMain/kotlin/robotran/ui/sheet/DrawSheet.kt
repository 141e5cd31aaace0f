package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.workshop.state.SheetLayer

/**
 * Paints the desk, the paper and everything that lies, stands, shines and drives on it; fills the draw area. The screen
 * and exported pictures both use it.
 *
 * @param labels what the robots' names and the numbers of goals are written with; null for leaving them out.
 * @param shown what is drawn beside that.
 * @param view where the sheet is to be, if not where [drawing] was made for.
 */
fun DrawScope.drawSheet(
    drawing: SheetDrawing,
    state: SessionState,
    colours: SheetColours,
    labels: TextMeasurer? = null,
    shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    view: SheetTransform = drawing.transform,
) {
    drawRect(colours.desk)
    inView(drawing, view) { visible ->
        drawGround(drawing, colours)
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
        drawSolids(drawing.solids)
        for ((block, pose) in drawing.blocks.zip(state.blocks)) drawBlock(block, pose, drawing.transform)
        for ((place, robot) in drawing.world.robots.zip(state.robots)) drawRobot(robot.robot, place, drawing.transform)
        drawLamps(drawing.world, state, drawing.transform)
    }
    if (labels == null) return
    if (SheetLayer.GRID in shown) drawGridFigures(drawing.world.paper, view, colours, labels)
    if (SheetLayer.NAMES in shown) drawThingNames(drawing.world, state, view, labels)
    if (SheetLayer.NAMES in shown || state.robots.size > 1) drawRobotNames(drawing.world.robots, state, view, labels)
    if (SheetLayer.SENSORS in shown) drawReadings(drawing.world, state, view, labels)
}

/** Draws where [drawing] was made for, to be seen at [view]; what is told is which part of that can be seen. */
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

/** What lies still under all else: paper, marks and the drawing to be traced. */
internal fun DrawScope.drawGround(drawing: SheetDrawing, colours: SheetColours) {
    drawPaper(colours, drawing.transform)
    val paper = drawing.transform.paper
    clipRect(paper.left, paper.top, paper.right, paper.bottom) { for (mark in drawing.marks) drawMark(mark) }
    drawing.template?.let { drawTemplate(it, drawing.transform) }
}

private fun DrawScope.drawPaper(colours: SheetColours, transform: SheetTransform) {
    val paper = transform.paper
    val shadow = 2.dp.toPx()
    drawRect(colours.paperEdge, paper.topLeft + Offset(shadow, shadow), paper.size)
    drawRect(colours.paper, paper.topLeft, paper.size)
    drawRect(colours.paperEdge, paper.topLeft, paper.size, style = Stroke(1f))
}
