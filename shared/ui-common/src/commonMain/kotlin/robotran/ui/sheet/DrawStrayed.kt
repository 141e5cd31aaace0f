package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.unit.dp
import robotran.uikit.*
import robotran.workshop.state.StrayedRobot
import robotran.world.World
import kotlin.math.PI
import kotlin.math.atan2

/** An arrow in the colour of each robot that has left the paper, at the edge where it is nearest, towards it. */
fun DrawScope.drawStrayed(strayed: List<StrayedRobot>, world: World, sheet: SheetTransform) {
    val margin = (RADIUS + 2.dp).toPx()
    for (robot in strayed) {
        val target = sheet.toPixels(robot.place.x, robot.place.y)
        val edge = sheet.toPixels(robot.edge.x, robot.edge.y)
        // Of an enlarged sheet, the edge of the paper may be out of sight, too.
        val middle = Offset(
            edge.x.coerceIn(minOf(margin, size.width / 2), maxOf(size.width - margin, size.width / 2)),
            edge.y.coerceIn(minOf(margin, size.height / 2), maxOf(size.height - margin, size.height / 2)),
        )
        drawArrow(middle, target - middle, world, robot)
    }
}

private fun DrawScope.drawArrow(middle: Offset, towards: Offset, world: World, robot: StrayedRobot) {
    val radius = RADIUS.toPx()
    val colour = world.robots[robot.robot].colour
    val arrow = Path().apply {
        moveTo(radius, 0f)
        lineTo(-radius * 0.7f, radius * 0.85f)
        lineTo(-radius * 0.3f, 0f)
        lineTo(-radius * 0.7f, -radius * 0.85f)
        close()
    }
    withTransform({
        translate(middle.x, middle.y)
        rotate((atan2(towards.y, towards.x) * HALF_TURN / PI).toFloat(), Offset.Zero)
    }) {
        drawPath(arrow, RobotranColours.CASING, style = Stroke(5.dp.toPx(), join = StrokeJoin.Round))
        drawPath(arrow, RobotColours.brick(colour))
        drawPath(arrow, RobotColours.edge(colour), style = Stroke(1.5f.dp.toPx(), join = StrokeJoin.Round))
    }
}

private val RADIUS = 16.dp
private const val HALF_TURN = 180.0
