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
import robotran.world.RobotColour
import robotran.world.RobotPlacement

/**
 * The robot from above, true to scale: a brick in the colour of [build] on a black chassis, two wheels, bumpers in
 * front, the pen between the wheels, two eyes with the look of [face], and optionally a lamp on top.
 */
internal fun DrawScope.drawRobot(
    robot: RobotState,
    build: RobotPlacement,
    transform: SheetTransform,
    face: PenbotFace = PenbotFace.STILL,
) {
    val place = transform.toPixels(robot.pose.x, robot.pose.y)
    val scale = transform.pixelsPerCentimetre
    withTransform({
        translate(place.x, place.y)
        // The screen's y axis points down, so a counter-clockwise turn is a negative angle.
        rotate(-robot.pose.heading.toFloat(), Offset.Zero)
        scale(scale, scale, Offset.Zero)
    }) {
        drawWheel(-RobotPlan.WHEEL_MIDDLE, robot.leftWheelTurn)
        drawWheel(RobotPlan.WHEEL_MIDDLE, robot.rightWheelTurn)
        drawBumper(RobotPlan.LEFT_BUMPER, robot.leftBumperPressed)
        drawBumper(RobotPlan.RIGHT_BUMPER, robot.rightBumperPressed)
        plate(RobotPlan.AXLE, RobotColours.TREAD, 0.2f)
        plate(RobotPlan.CHASSIS, RobotColours.CHASSIS, 1f, RobotColours.CHASSIS_EDGE)
        for (motor in RobotPlan.MOTORS) plate(motor, RobotColours.MOTOR, 0.4f, RobotColours.CHASSIS_EDGE)
        drawBrickFromAbove(build.colour)
        plate(RobotPlan.LIGHT_SENSOR, RobotColours.LIGHT_SENSOR, 0.3f, RobotColours.CHASSIS_EDGE)
        drawEyes(face, RobotColours.brick(build.colour), RobotColours.edge(build.colour))
        drawPen(robot.penDown)
        if (build.beacon > 0) drawBeacon()
    }
}

private fun DrawScope.drawWheel(y: Float, turn: Double) {
    val tyre = Rect(
        -RobotPlan.WHEEL_RADIUS,
        y - RobotPlan.WHEEL_WIDTH / 2,
        RobotPlan.WHEEL_RADIUS,
        y + RobotPlan.WHEEL_WIDTH / 2,
    )
    plate(tyre, RobotColours.TYRE, 0.7f, RobotColours.CHASSIS_EDGE)
    for (x in treadPlaces(turn, RobotPlan.TREADS, RobotPlan.WHEEL_RADIUS)) {
        drawLine(RobotColours.TREAD, Offset(x, tyre.top + 0.3f), Offset(x, tyre.bottom - 0.3f), 0.22f, StrokeCap.Round)
    }
}

private fun DrawScope.drawBumper(place: Rect, pressed: Boolean) {
    val moved = if (pressed) place.translate(-RobotPlan.BUMPER_TRAVEL, 0f) else place
    val arm = Rect(RobotPlan.CHASSIS.right - 0.5f, place.center.y - 0.3f, moved.left + 0.2f, place.center.y + 0.3f)
    plate(arm, RobotColours.BUMPER_EDGE, 0.1f)
    plate(moved, if (pressed) RobotColours.BUMPER_EDGE else RobotColours.BUMPER, 0.6f, RobotColours.BUMPER_EDGE)
}

private fun DrawScope.drawBrickFromAbove(colour: RobotColour) {
    plate(RobotPlan.BRICK, RobotColours.brick(colour), 0.6f, RobotColours.edge(colour))
    plate(RobotPlan.DISPLAY, RobotColours.GLASS, 0.2f, RobotColours.CHASSIS)
    for ((place, colour) in RobotPlan.BUTTONS.zip(RobotColours.BUTTONS)) drawCircle(colour, 0.55f, place)
    for (place in RobotPlan.INPUTS) plate(place, RobotColours.BUMPER, 0.15f)
    for (place in RobotPlan.OUTPUTS) plate(place, RobotColours.CHASSIS, 0.15f)
}

/** The pen in its clip; the tip is red while it touches the paper. */
private fun DrawScope.drawPen(down: Boolean) {
    drawCircle(RobotColours.CLIP, RobotPlan.CLIP_RADIUS, RobotPlan.PEN)
    drawCircle(RobotColours.CHASSIS_EDGE, RobotPlan.CLIP_RADIUS, RobotPlan.PEN, style = Stroke(0.15f))
    drawCircle(if (down) RobotColours.PEN_TIP_DOWN else RobotColours.PEN_TIP_UP, RobotPlan.PEN_RADIUS, RobotPlan.PEN)
    drawCircle(RobotColours.CHASSIS_EDGE, RobotPlan.PEN_RADIUS, RobotPlan.PEN, style = Stroke(0.12f))
}

private fun DrawScope.drawBeacon() {
    drawCircle(SheetColours.LAMP, RobotPlan.BEACON_RADIUS, RobotPlan.BEACON)
    drawCircle(SheetColours.LAMP_CORE, RobotPlan.BEACON_RADIUS / 2, RobotPlan.BEACON)
    drawCircle(SheetColours.LAMP_EDGE, RobotPlan.BEACON_RADIUS, RobotPlan.BEACON, style = Stroke(0.15f))
}

private fun DrawScope.plate(place: Rect, colour: Color, corner: Float, edge: Color? = null) {
    val radius = CornerRadius(corner)
    val size = Size(place.width, place.height)
    drawRoundRect(colour, place.topLeft, size, radius)
    if (edge != null) drawRoundRect(edge, place.topLeft, size, radius, style = Stroke(0.15f))
}
