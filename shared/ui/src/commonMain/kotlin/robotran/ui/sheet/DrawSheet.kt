package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.world.SessionState
import robotran.world.World

/** Paints the desk, the paper, what stands on it, the ink and the robot; fills the draw area. The screen and exported pictures both use it. */
fun DrawScope.drawSheet(world: World, state: SessionState, colours: SheetColours, transform: SheetTransform) {
    drawRect(colours.desk)
    drawPaper(colours, transform)
    drawInk(state.ink, transform)
    drawWalls(world, transform)
    drawRobot(state.robot, transform)
}

private fun DrawScope.drawPaper(colours: SheetColours, transform: SheetTransform) {
    val paper = transform.paper
    val shadow = 2.dp.toPx()
    drawRect(colours.paperEdge, paper.topLeft + Offset(shadow, shadow), paper.size)
    drawRect(colours.paper, paper.topLeft, paper.size)
    drawRect(colours.paperEdge, paper.topLeft, paper.size, style = Stroke(1f))
}
