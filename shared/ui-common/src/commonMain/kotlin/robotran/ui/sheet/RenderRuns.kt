package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.max

/** A robot's path in one run and its final pose. */
class RobotTrack(val way: List<Point>, val end: Pose)

/**
 * A picture of several runs in the same world on top of each other, each in its own colour, with an arrow at its end.
 * Their differences show the effect of chance. As wide as [renderSheet] allows.
 */
fun renderRuns(world: World, runs: List<RobotTrack>, widthPixels: Int = PICTURE_PIXELS): ImageBitmap =
    renderOn(world, widthPixels) { drawing ->
        drawRect(SheetColours.LIGHT.desk)
        drawGround(drawing, SheetColours.LIGHT)
        CanvasTarget(this).drawSolids(drawing.solids)
        runs.forEachIndexed { number, run -> drawTrack(run, runColour(number, runs.size), drawing.transform) }
    }

private fun DrawScope.drawTrack(run: RobotTrack, colour: Color, transform: SheetTransform) {
    val width = max(LINE_CENTIMETRES * transform.pixelsPerCentimetre, 1f)
    val line = Stroke(width, cap = StrokeCap.Round, join = StrokeJoin.Round)
    drawPath(Path().apply { addLine(run.way.map { transform.toPixels(it.x, it.y) }) }, colour, style = line)
    drawPath(arrow(run.end, transform), colour)
}

/** The tip is at the robot's position and points in its direction. */
private fun arrow(pose: Pose, transform: SheetTransform): Path {
    val tip = Point(pose.x, pose.y)
    val heading = pose.heading * RADIANS_PER_DEGREE
    val back = tip.towards(heading, -ARROW_CENTIMETRES)
    val corners = listOf(
        tip,
        back.towards(heading + QUARTER_TURN, ARROW_CENTIMETRES / 3),
        back.towards(
            heading - QUARTER_TURN,
            ARROW_CENTIMETRES / 3,
        ),
    )
    return Path().apply { addLine(corners.map { transform.toPixels(it.x, it.y) }, closed = true) }
}

/** Evenly distributed hues. */
private fun runColour(number: Int, runs: Int) = Color.hsv(360f * number / runs, 0.85f, 0.75f, alpha = 0.75f)

private const val LINE_CENTIMETRES = 0.2f
private const val ARROW_CENTIMETRES = 3.0
private const val QUARTER_TURN = kotlin.math.PI / 2
