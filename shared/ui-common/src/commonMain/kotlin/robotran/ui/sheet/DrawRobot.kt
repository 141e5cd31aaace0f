package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.simulation.state.RobotState
import robotran.uikit.*
import robotran.world.RobotPlacement

/**
 * The robot from above, true to scale: a brick in the colour of [build] on a black chassis, two wheels, bumpers,
 * sensors, the pen between the wheels, two eyes with the look of [face], and optionally a lamp on top.
 *
 * @param plan of the robot of [build].
 * @param hasEyes whether the eyes are drawn, which may hide sensors.
 */
fun DrawScope.drawRobot(
    robot: RobotState,
    build: RobotPlacement,
    plan: RobotPlan,
    transform: SheetTransform,
    face: PenbotFace = PenbotFace.STILL,
    hasEyes: Boolean = true,
) {
    val place = transform.toPixels(robot.pose.x, robot.pose.y)
    val scale = transform.pixelsPerCentimetre
    withTransform({
        translate(place.x, place.y)
        // The screen's y axis points down, so a counter-clockwise turn is a negative angle.
        rotate(-robot.pose.heading.toFloat(), Offset.Zero)
        scale(scale, scale, Offset.Zero)
    }) {
        drawWheel(plan, -plan.wheelMiddle, robot.leftWheelTurn)
        drawWheel(plan, plan.wheelMiddle, robot.rightWheelTurn)
        CanvasBrush(this).drawBody(plan, build, robot)
        if (hasEyes) drawEyes(plan.eyes, face, RobotColours.brick(build.colour), RobotColours.edge(build.colour))
        if (plan.hasPen) drawPen(robot.penDown)
        if (build.beacon > 0) drawBeacon(plan.beacon)
    }
}

private class CanvasBrush(private val scope: DrawScope) : RobotBrush {
    override fun plate(bounds: Rect, colour: Color, corner: Float, edge: Color?) =
        scope.plate(bounds, colour, corner, edge)

    override fun disc(middle: Offset, radius: Float, colour: Color, edge: Color?) {
        scope.drawCircle(colour, radius, middle)
        if (edge != null) scope.drawCircle(edge, radius, middle, style = Stroke(EDGE_WIDTH))
    }

    override fun shape(corners: List<Offset>, colour: Color, edge: Color) {
        val path = pathOf(corners)
        scope.drawPath(path, colour)
        scope.drawPath(path, edge, style = Stroke(EDGE_WIDTH))
    }

    override fun turned(middle: Offset, degrees: Float, content: RobotBrush.() -> Unit) = scope.withTransform({
        translate(middle.x, middle.y)
        rotate(degrees, Offset.Zero)
    }) { content() }
}

private fun DrawScope.drawWheel(plan: RobotPlan, y: Float, turn: Double) {
    val tyre = Rect(-plan.wheelRadius, y - plan.wheelWidth / 2, plan.wheelRadius, y + plan.wheelWidth / 2)
    plate(tyre, RobotColours.TYRE, 0.7f, RobotColours.CHASSIS_EDGE)
    for (x in treadPlaces(turn, RobotPlan.TREADS, plan.wheelRadius)) {
        drawLine(RobotColours.TREAD, Offset(x, tyre.top + 0.3f), Offset(x, tyre.bottom - 0.3f), 0.22f, StrokeCap.Round)
    }
}

/** The pen in its clip; the tip is red while it touches the paper. */
private fun DrawScope.drawPen(down: Boolean) {
    drawCircle(RobotColours.CLIP, RobotPlan.CLIP_RADIUS, RobotPlan.PEN)
    drawCircle(RobotColours.CHASSIS_EDGE, RobotPlan.CLIP_RADIUS, RobotPlan.PEN, style = Stroke(EDGE_WIDTH))
    drawCircle(if (down) RobotColours.PEN_TIP_DOWN else RobotColours.PEN_TIP_UP, RobotPlan.PEN_RADIUS, RobotPlan.PEN)
    drawCircle(RobotColours.CHASSIS_EDGE, RobotPlan.PEN_RADIUS, RobotPlan.PEN, style = Stroke(0.12f))
}

private fun DrawScope.drawBeacon(position: Offset) {
    drawCircle(SheetColours.LAMP, RobotPlan.BEACON_RADIUS, position)
    drawCircle(SheetColours.LAMP_CORE, RobotPlan.BEACON_RADIUS / 2, position)
    drawCircle(SheetColours.LAMP_EDGE, RobotPlan.BEACON_RADIUS, position, style = Stroke(EDGE_WIDTH))
}

private fun DrawScope.plate(bounds: Rect, colour: Color, corner: Float, edge: Color? = null) {
    val radius = CornerRadius(corner)
    val size = Size(bounds.width, bounds.height)
    drawRoundRect(colour, bounds.topLeft, size, radius)
    if (edge != null) drawRoundRect(edge, bounds.topLeft, size, radius, style = Stroke(EDGE_WIDTH))
}

private const val EDGE_WIDTH = 0.15f
