package robotran.ui.robot

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotHandle
import robotran.robotediting.SensorView
import robotran.robotediting.elementOf
import robotran.robotediting.handles
import robotran.robotediting.placeOf
import robotran.robotediting.portsOf
import robotran.robotediting.views
import robotran.simulation.state.RobotState
import robotran.ui.editing.HandleAt
import robotran.ui.editing.drawKnob
import robotran.ui.sheet.CanvasTarget
import robotran.ui.sheet.RobotPlan
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.drawRobot
import robotran.uikit.*
import robotran.world.RobotColour
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.robot.things
import kotlin.math.ceil
import kotlin.math.floor

/** The plan: squared paper, what the sensors see, the robot, its ports, and the signs of the workbench. */
internal fun DrawScope.drawPlan(
    editing: RobotEditing,
    plan: RobotPlan,
    colour: RobotColour,
    transform: SheetTransform,
    measurer: TextMeasurer,
    colours: RobotranColours,
) {
    val robot = editing.robot
    drawSquares(transform, colours)
    for (view in robot.views()) drawView(view, transform, isChosen = editing.chosen == RobotElement.Part(view.number))
    val place = RobotPlacement(STANDING.pose, colour = colour, description = robot)
    CanvasTarget(this).drawRobot(STANDING, place, plan, transform, hasEyes = false)
    for (caster in robot.casters) drawCaster(transform.ofRobot(caster), transform)
    drawMass(transform.ofRobot(robot.chassis.massAt), transform)
    editing.chosen?.let { drawFrame(robot, it, transform) }
    drawLabels(robot, transform, measurer)
    for (error in editing.errors) {
        robot.elementOf(error)?.let { drawWarning(transform.ofRobot(signPlace(robot, it)), colours) }
    }
    if (editing.gesture == null) {
        for (placed in placedHandles(editing, transform, density)) {
            val isRound = placed.handle is RobotHandle.Direction || placed.handle is RobotHandle.Corner
            drawKnob(placed.at, isRound, KNOB)
        }
    }
}

/** Handles at places that leave room for a finger on the element itself; [density] is pixels per dp. */
internal fun placedHandles(
    editing: RobotEditing,
    transform: SheetTransform,
    density: Float,
): List<HandleAt<RobotHandle>> {
    val middle = (editing.chosen as? RobotElement.Part)?.let { editing.robot.placeOf(it) }?.let(transform::ofRobot)
    return editing.handles().map { placed ->
        val place = transform.ofRobot(placed.at)
        val outwards = middle?.let { place - it } ?: Offset.Zero
        val distance = outwards.getDistance()
        if (placed.handle is RobotHandle.Direction && distance > 0f) {
            HandleAt(placed.handle, place - outwards + outwards * (TURN_DISTANCE * density / distance))
        } else {
            HandleAt(placed.handle, place)
        }
    }
}

/** A line every centimetre, and a stronger one every five. */
private fun DrawScope.drawSquares(transform: SheetTransform, colours: RobotranColours) {
    drawRect(colours.paper)
    val low = transform.toCentimetres(Offset(0f, size.height))
    val high = transform.toCentimetres(Offset(size.width, 0f))
    val fine = transform.pixelsPerCentimetre >= FINE_GRID.toPx()

    fun colourOf(number: Int) = SheetColours.GRID.copy(
        alpha = when {
            number == 0 -> 0.5f
            number % STRONG == 0 -> 0.25f
            else -> 0.1f
        },
    )
    for (x in ceil(low.x).toInt()..floor(high.x).toInt()) {
        if (fine || x % STRONG == 0) {
            val at = transform.toPixels(x.toDouble(), 0.0).x
            drawLine(colourOf(x), Offset(at, 0f), Offset(at, size.height), 1f)
        }
    }
    for (y in ceil(low.y).toInt()..floor(high.y).toInt()) {
        if (fine || y % STRONG == 0) {
            val at = transform.toPixels(0.0, y.toDouble()).y
            drawLine(colourOf(y), Offset(0f, at), Offset(size.width, at), 1f)
        }
    }
}

private fun DrawScope.drawView(view: SensorView, transform: SheetTransform, isChosen: Boolean) {
    val strength = if (isChosen) 1f else 0.6f
    when (view) {
        is SensorView.Spot -> {
            val centre = transform.ofRobot(view.at)
            val radius = transform.toPixels(view.radius * SPOT_SHOWN)
            drawCircle(SheetColours.SIGHT.copy(alpha = 0.35f * strength), radius, centre)
            drawCircle(SheetColours.SIGHT.copy(alpha = strength), radius, centre, style = Stroke(1.5.dp.toPx()))
        }

        is SensorView.Cone -> drawCone(view, transform, strength)
    }
}

/** A sonar has the rays of its model, a light sensor only an area. */
private fun DrawScope.drawCone(view: SensorView.Cone, transform: SheetTransform, strength: Float) {
    val eye = transform.ofRobot(view.eye)
    val ends = view.rays.map { angle -> transform.ofRobot(Direction(angle).from(view.eye, view.reach, 0.0)) }
    val path = Path().apply {
        moveTo(eye.x, eye.y)
        for (end in ends) lineTo(end.x, end.y)
        close()
    }
    val reach = minOf(transform.toPixels(view.reach), size.maxDimension)
    val fading = Brush.radialGradient(
        0f to SheetColours.SIGHT.copy(alpha = 0.4f * strength),
        1f to SheetColours.SIGHT.copy(alpha = 0.06f * strength),
        center = eye,
        radius = reach.coerceAtLeast(1f),
    )
    drawPath(path, fading)
    if (view.isSound) {
        for (end in ends) drawLine(SheetColours.SIGHT.copy(alpha = 0.25f * strength), eye, end, 1f)
    }
    for (end in listOf(ends.first(), ends.last())) {
        drawLine(SheetColours.SIGHT.copy(alpha = 0.7f * strength), eye, end, 1.5.dp.toPx())
    }
}

/** Below the chassis, therefore dashed. */
private fun DrawScope.drawCaster(at: Offset, transform: SheetTransform) {
    val radius = transform.toPixels(CASTER_RADIUS)
    val dashes = PathEffect.dashPathEffect(floatArrayOf(3.dp.toPx(), 3.dp.toPx()))
    drawCircle(RobotBenchColours.CASTER.copy(alpha = 0.4f), radius, at)
    drawCircle(RobotBenchColours.CASTER, radius, at, style = Stroke(3.dp.toPx()))
    drawCircle(RobotranColours.CASING, radius, at, style = Stroke(1.5.dp.toPx(), pathEffect = dashes))
}

/** The sign of a centre of mass: two dark and two light quarters. */
private fun DrawScope.drawMass(at: Offset, transform: SheetTransform) {
    val radius = transform.toPixels(MASS_RADIUS).coerceAtLeast(5.dp.toPx())
    val box = Rect(at, radius)
    drawCircle(RobotranColours.CASING, radius, at)
    for (start in listOf(0f, 180f)) drawArc(RobotranColours.SHADE, start, 90f, true, box.topLeft, box.size)
    drawCircle(RobotranColours.SHADE, radius, at, style = Stroke(1.5.dp.toPx()))
}

/** The numbers of ports at what is plugged in, and the letters of motors. */
private fun DrawScope.drawLabels(robot: RobotDescription, transform: SheetTransform, measurer: TextMeasurer) {
    val taken = mutableListOf<Offset>()
    val apart = LABEL_APART.toPx()
    robot.things.forEachIndexed { number, _ ->
        val ports = robot.portsOf(number)
        val at = robot.placeOf(RobotElement.Part(number))
        if (ports.isNotEmpty() && at != null) {
            var place = transform.ofRobot(at)
            while (taken.any { (it - place).getDistance() < apart }) place += Offset(apart, 0f)
            taken += place
            drawLabel(ports.joinToString(" "), place, measurer)
        }
    }
    val wheel = robot.drive.track / 2
    val behind = -robot.drive.wheelDiameter * LABEL_BEHIND_AXLE
    drawLabel(robot.drive.left.name, transform.ofRobot(Point(behind, wheel)), measurer)
    drawLabel(robot.drive.right.name, transform.ofRobot(Point(behind, -wheel)), measurer)
    robot.pen?.let { drawLabel(it.motor.name, transform.ofRobot(Point(-LABEL_BEHIND_PEN, 0.0)), measurer) }
}

private fun DrawScope.drawLabel(text: String, at: Offset, measurer: TextMeasurer) {
    val measured = measurer.measure(text, LABEL_STYLE)
    val half = Size(measured.size.width / 2f + 4.dp.toPx(), measured.size.height / 2f + 1.dp.toPx())
    val width = maxOf(half.width, half.height)
    val corner = at - Offset(width, half.height)
    val size = Size(width * 2, half.height * 2)
    drawRoundRect(RobotranColours.CASING, corner, size, CornerRadius(half.height))
    drawRoundRect(RobotBenchColours.LABEL_EDGE, corner, size, CornerRadius(half.height), style = Stroke(1.dp.toPx()))
    drawText(measured, topLeft = at - Offset(measured.size.width / 2f, measured.size.height / 2f))
}

/** At the middle of the plan, looking up. */
private val STANDING = RobotState(
    Pose(0.0, 0.0, 90.0),
    0.0,
    0.0,
    penDown = false,
    leftBumperPressed = false,
    rightBumperPressed = false,
)

private const val STRONG = 5
private val FINE_GRID = 6.dp
private const val SPOT_SHOWN = 2.0
private const val CASTER_RADIUS = 0.6
private const val MASS_RADIUS = 0.45
private const val LABEL_BEHIND_PEN = 2.0
private const val LABEL_BEHIND_AXLE = 0.3

/** Between the middles of two labels, which would hide each other. */
private val LABEL_APART = 22.dp
private const val TURN_DISTANCE = 56f
private val LABEL_STYLE =
    TextStyle(color = RobotBenchColours.LABEL, fontSize = TextSizes.SIGN, fontWeight = FontWeight.Bold)
private val KNOB = 8.dp
