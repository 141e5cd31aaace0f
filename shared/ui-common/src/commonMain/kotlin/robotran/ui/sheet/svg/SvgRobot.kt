package robotran.ui.sheet.svg

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import robotran.simulation.state.RobotState
import robotran.ui.sheet.PenbotFace
import robotran.ui.sheet.RobotBrush
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.RobotPlan
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.drawBody
import robotran.uikit.*
import robotran.world.RobotPlacement

/** Writes the robot from above, the same as on the screen, see [RobotPlan]. */
internal class SvgRobot(private val svg: SvgWriter) : RobotBrush {
    /** @param down its pen's distance from the top of the picture. */
    fun write(build: RobotPlacement, robot: RobotState, down: Double, face: PenbotFace) {
        val plan = RobotPlan(build.description)
        val place = "translate(${figure(robot.pose.x)} ${figure(down)}) rotate(${figure(-robot.pose.heading)})"
        svg.element("g", "transform" to place) {
            for (side in listOf(-1, 1)) wheel(plan, side * plan.wheelMiddle)
            drawBody(plan, build, robot)
            for (eye in plan.eyes) eye(eye, face)
            if (plan.hasPen) {
                disc(RobotPlan.PEN, RobotPlan.CLIP_RADIUS, RobotColours.CLIP, RobotColours.CHASSIS_EDGE)
                val tip = if (robot.penDown) RobotColours.PEN_TIP_DOWN else RobotColours.PEN_TIP_UP
                disc(RobotPlan.PEN, RobotPlan.PEN_RADIUS, tip, RobotColours.CHASSIS_EDGE)
            }
            if (build.beacon > 0) {
                disc(plan.beacon, RobotPlan.BEACON_RADIUS, SheetColours.LAMP, SheetColours.LAMP_EDGE)
            }
        }
    }

    private fun wheel(plan: RobotPlan, y: Float) {
        val radius = plan.wheelRadius
        val half = plan.wheelWidth / 2
        plate(Rect(-radius, y - half, radius, y + half), RobotColours.TYRE, 0.7f, RobotColours.CHASSIS_EDGE)
        for (tread in -TREADS..TREADS) {
            val x = tread * radius / (TREADS + 1)
            plate(Rect(x - 0.11f, y - half + 0.3f, x + 0.11f, y + half - 0.3f), RobotColours.TREAD, 0.1f)
        }
    }

    /** Open, whatever the mood: lids tell a story that a picture does not have. */
    private fun eye(middle: Offset, face: PenbotFace) {
        disc(middle, RobotPlan.EYE_RADIUS, RobotColours.EYE, RobotColours.CHASSIS_EDGE)
        disc(middle + face.gaze * RobotPlan.GAZE, RobotPlan.PUPIL_RADIUS, RobotColours.PUPIL)
    }

    override fun plate(bounds: Rect, colour: Color, corner: Float, edge: Color?) = svg.element(
        "rect",
        "x" to bounds.left,
        "y" to bounds.top,
        "width" to bounds.width,
        "height" to bounds.height,
        "rx" to corner,
        "fill" to hex(colour),
        "stroke" to edge?.let(::hex),
        "stroke-width" to EDGE_WIDTH.takeIf { edge != null },
    )

    override fun disc(middle: Offset, radius: Float, colour: Color, edge: Color?) = svg.element(
        "circle",
        "cx" to middle.x,
        "cy" to middle.y,
        "r" to radius,
        "fill" to hex(colour),
        "stroke" to edge?.let(::hex),
        "stroke-width" to EDGE_WIDTH.takeIf { edge != null },
    )

    override fun shape(corners: List<Offset>, colour: Color, edge: Color) = svg.element(
        "polygon",
        "points" to corners.joinToString(" ") { "${figure(it.x.toDouble())},${figure(it.y.toDouble())}" },
        "fill" to hex(colour),
        "stroke" to hex(edge),
        "stroke-width" to EDGE_WIDTH,
    )

    override fun turned(middle: Offset, degrees: Float, content: RobotBrush.() -> Unit) {
        val x = figure(middle.x.toDouble())
        val y = figure(middle.y.toDouble())
        svg.element("g", "transform" to "translate($x $y) rotate(${figure(degrees.toDouble())})") { content() }
    }

    private companion object {
        const val EDGE_WIDTH = 0.15

        /** The number of treads on each side of the middle one. */
        const val TREADS = 3
    }
}
