package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.dp
import robotran.world.SessionState

/**
 * Paints the desk, the paper and everything that lies, stands, shines and drives on it; fills the draw area. The screen and exported
 * pictures both use it.
 *
 * @param labels what the robots' names and the numbers of goals are written with; null for leaving them out.
 */
fun DrawScope.drawSheet(drawing: SheetDrawing, state: SessionState, colours: SheetColours, labels: TextMeasurer? = null) {
    drawGround(drawing, colours)
    for (region in drawing.regions) drawRegion(region, state.goals, drawing.transform, labels)
    drawInk(drawing.ink, state.ink, drawing.world.robots)
    drawGlow(drawing.glow, state)
    drawSolids(drawing.solids)
    for ((block, pose) in drawing.blocks.zip(state.blocks)) drawBlock(block, pose, drawing.transform)
    for ((place, robot) in drawing.world.robots.zip(state.robots)) drawRobot(robot.robot, place, drawing.transform)
    drawLamps(drawing.world, state, drawing.transform)
    if (labels != null && state.robots.size > 1) drawRobotNames(drawing.world.robots, state, drawing.transform, labels)
}

/** What lies still under all else: desk, paper, marks and the drawing to be traced. */
internal fun DrawScope.drawGround(drawing: SheetDrawing, colours: SheetColours) {
    drawRect(colours.desk)
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
