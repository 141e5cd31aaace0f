package robotran.ui.sheet.svg

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import robotran.simulation.state.RobotState
import robotran.ui.sheet.PenbotFace
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.RobotPlan
import robotran.ui.sheet.SheetColours
import robotran.world.RobotPlacement

/** Writes the robot from above, the same as on the screen, see [RobotPlan]. */
internal class SvgRobot(private val svg: SvgWriter) {
    /** @param down its pen's distance from the top of the picture. */
    fun write(build: RobotPlacement, robot: RobotState, down: Double, face: PenbotFace) {
        val place = "translate(${figure(robot.pose.x)} ${figure(down)}) rotate(${figure(-robot.pose.heading)})"
        svg.element("g", "transform" to place) {
            for (side in listOf(-1, 1)) wheel(side * RobotPlan.WHEEL_MIDDLE)
            bumper(RobotPlan.LEFT_BUMPER, robot.leftBumperPressed)
            bumper(RobotPlan.RIGHT_BUMPER, robot.rightBumperPressed)
            plate(RobotPlan.AXLE, RobotColours.TREAD, 0.2)
            plate(RobotPlan.CHASSIS, RobotColours.CHASSIS, 1.0, RobotColours.CHASSIS_EDGE)
            for (motor in RobotPlan.MOTORS) plate(motor, RobotColours.MOTOR, 0.4, RobotColours.CHASSIS_EDGE)
            brick(build)
            plate(RobotPlan.LIGHT_SENSOR, RobotColours.LIGHT_SENSOR, 0.3, RobotColours.CHASSIS_EDGE)
            for (eye in RobotPlan.EYES) eye(eye, face)
            disc(RobotPlan.PEN, RobotPlan.CLIP_RADIUS, RobotColours.CLIP, RobotColours.CHASSIS_EDGE)
            val tip = if (robot.penDown) RobotColours.PEN_TIP_DOWN else RobotColours.PEN_TIP_UP
            disc(RobotPlan.PEN, RobotPlan.PEN_RADIUS, tip, RobotColours.CHASSIS_EDGE)
            if (build.beacon > 0) {
                disc(RobotPlan.BEACON, RobotPlan.BEACON_RADIUS, SheetColours.LAMP, SheetColours.LAMP_EDGE)
            }
        }
    }

    private fun wheel(y: Float) {
        val radius = RobotPlan.WHEEL_RADIUS
        val half = RobotPlan.WHEEL_WIDTH / 2
        plate(Rect(-radius, y - half, radius, y + half), RobotColours.TYRE, 0.7, RobotColours.CHASSIS_EDGE)
        for (tread in -TREADS..TREADS) {
            val x = tread * radius / (TREADS + 1)
            plate(Rect(x - 0.11f, y - half + 0.3f, x + 0.11f, y + half - 0.3f), RobotColours.TREAD, 0.1)
        }
    }

    private fun bumper(place: Rect, pressed: Boolean) {
        val moved = if (pressed) place.translate(-RobotPlan.BUMPER_TRAVEL, 0f) else place
        val arm = Rect(RobotPlan.CHASSIS.right - 0.5f, place.center.y - 0.3f, moved.left + 0.2f, place.center.y + 0.3f)
        plate(arm, RobotColours.BUMPER_EDGE, 0.1)
        plate(moved, if (pressed) RobotColours.BUMPER_EDGE else RobotColours.BUMPER, 0.6, RobotColours.BUMPER_EDGE)
    }

    private fun brick(build: RobotPlacement) {
        plate(RobotPlan.BRICK, RobotColours.brick(build.colour), 0.6, RobotColours.edge(build.colour))
        plate(RobotPlan.DISPLAY, RobotColours.GLASS, 0.2, RobotColours.CHASSIS)
        for ((place, colour) in RobotPlan.BUTTONS.zip(RobotColours.BUTTONS)) disc(place, 0.55f, colour)
        for (place in RobotPlan.INPUTS) plate(place, RobotColours.BUMPER, 0.15)
        for (place in RobotPlan.OUTPUTS) plate(place, RobotColours.CHASSIS, 0.15)
    }

    /** Open, whatever the mood: lids tell a story that a picture does not have. */
    private fun eye(middle: Offset, face: PenbotFace) {
        disc(middle, RobotPlan.EYE_RADIUS, RobotColours.EYE, RobotColours.CHASSIS_EDGE)
        disc(middle + face.gaze * RobotPlan.GAZE, RobotPlan.PUPIL_RADIUS, RobotColours.PUPIL)
    }

    private fun plate(place: Rect, colour: Color, corner: Double, edge: Color? = null) = svg.element(
        "rect",
        "x" to place.left,
        "y" to place.top,
        "width" to place.width,
        "height" to place.height,
        "rx" to corner,
        "fill" to hex(colour),
        "stroke" to edge?.let(::hex),
        "stroke-width" to EDGE_WIDTH.takeIf { edge != null },
    )

    private fun disc(middle: Offset, radius: Float, colour: Color, edge: Color? = null) = svg.element(
        "circle",
        "cx" to middle.x,
        "cy" to middle.y,
        "r" to radius,
        "fill" to hex(colour),
        "stroke" to edge?.let(::hex),
        "stroke-width" to EDGE_WIDTH.takeIf { edge != null },
    )

    private companion object {
        const val EDGE_WIDTH = 0.15

        /** The number of treads on each side of the middle one. */
        const val TREADS = 3
    }
}
