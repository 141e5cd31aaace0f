package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
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
fun DrawTarget.drawRobot(
    robot: RobotState,
    build: RobotPlacement,
    plan: RobotPlan,
    transform: SheetTransform,
    face: PenbotFace = PenbotFace.STILL,
    hasEyes: Boolean = true,
) {
    val place = transform.toPixels(robot.pose.x, robot.pose.y)
    // The y axis points down, so a counter-clockwise turn is a negative angle.
    group(place, -robot.pose.heading.toFloat(), scale = transform.pixelsPerCentimetre) {
        drawWheel(plan, -plan.wheelMiddle, robot.leftWheelTurn)
        drawWheel(plan, plan.wheelMiddle, robot.rightWheelTurn)
        drawBody(plan, build, robot)
        if (hasEyes) drawEyes(plan.eyes, face, RobotColours.brick(build.colour), RobotColours.edge(build.colour))
        if (plan.hasPen) drawPen(robot.penDown)
        if (build.beacon > 0) drawBeacon(plan.beacon)
    }
}

private fun DrawTarget.drawWheel(plan: RobotPlan, y: Float, turn: Double) {
    val tyre = Rect(-plan.wheelRadius, y - plan.wheelWidth / 2, plan.wheelRadius, y + plan.wheelWidth / 2)
    box(tyre, RobotColours.TYRE, 0.7f, RobotColours.CHASSIS_EDGE)
    for (x in treadPlaces(turn, RobotPlan.TREADS, plan.wheelRadius)) {
        line(Offset(x, tyre.top + 0.3f), Offset(x, tyre.bottom - 0.3f), RobotColours.TREAD, 0.22f, isRound = true)
    }
}

/** The pen in its clip; the tip is red while it touches the paper. */
private fun DrawTarget.drawPen(down: Boolean) {
    disc(RobotPlan.PEN, RobotPlan.CLIP_RADIUS, RobotColours.CLIP, RobotColours.CHASSIS_EDGE)
    val tip = if (down) RobotColours.PEN_TIP_DOWN else RobotColours.PEN_TIP_UP
    disc(RobotPlan.PEN, RobotPlan.PEN_RADIUS, tip, RobotColours.CHASSIS_EDGE, 0.12f)
}

private fun DrawTarget.drawBeacon(position: Offset) {
    disc(position, RobotPlan.BEACON_RADIUS, SheetColours.LAMP)
    disc(position, RobotPlan.BEACON_RADIUS / 2, SheetColours.LAMP_CORE)
    disc(position, RobotPlan.BEACON_RADIUS, fill = null, SheetColours.LAMP_EDGE)
}
