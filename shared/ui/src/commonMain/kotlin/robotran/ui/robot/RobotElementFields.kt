package robotran.ui.robot

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorPort
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotSnapping
import robotran.robotediting.placeOf
import robotran.ui.texts.RobotTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.ui.worldedit.HelpText
import robotran.ui.worldedit.NumberRow
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.Chassis
import robotran.world.Drive
import robotran.world.Facing
import robotran.world.PenMount
import robotran.world.RobotLimits
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.RobotParameters
import robotran.world.robot.things
import robotran.worldediting.written
import kotlin.math.round

/** What can be done with the chosen element. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun RobotElementActions(scope: RobotScope, element: RobotElement) {
    val part = (element as? RobotElement.Part)?.let { scope.robot.things.getOrNull(it.number) }
    val turns = part is BumperPart || (part as? SensorPart)?.facing is Facing.Ahead
    val stays = element == RobotElement.Wheels || element == RobotElement.Brick || element == RobotElement.Mass ||
        element == RobotElement.Chassis
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        if (!stays) {
            IconWord(EditIcons.DELETE, WorldEditorTexts.delete(spoken), "robot-remove", {
                scope.make(RobotEdit.Remove)
            })
        }
        if (turns) {
            IconWord(EditIcons.TURN_LEFT, WorldEditorTexts.turnLeft(spoken), "robot-turn-left", {
                scope.make(RobotEdit.TurnBy(RobotSnapping.DEGREES))
            })
            IconWord(EditIcons.TURN_RIGHT, WorldEditorTexts.turnRight(spoken), "robot-turn-right", {
                scope.make(RobotEdit.TurnBy(-RobotSnapping.DEGREES))
            })
        }
        if (element is RobotElement.Corner) {
            IconWord(EditIcons.LARGER, WorldEditorTexts.addCorner(spoken), "robot-add-corner", {
                scope.make(RobotEdit.AddCorner)
            })
        }
    }
}

@Composable
internal fun RobotElementFields(scope: RobotScope, element: RobotElement) {
    val robot = scope.robot
    when (element) {
        is RobotElement.Part -> PartFields(scope, element.number)
        RobotElement.Wheels -> WheelFields(scope)

        RobotElement.Pen -> {
            HelpText(RobotTexts.penHelp(spoken))
            MotorChips(RobotTexts::motor, robot.pen?.motor, "robot-pen-motor") {
                scope.changeAtOnce(robot.copy(pen = PenMount(it)))
            }
        }

        RobotElement.Brick -> {
            PlaceRows(scope, element)
            SwitchRow(RobotTexts.brickTurned(spoken), robot.brickAt.turned, "robot-brick-turned") {
                scope.changeAtOnce(robot.copy(brickAt = robot.brickAt.copy(turned = it)))
            }
        }

        RobotElement.Mass -> MassFields(scope)
        RobotElement.Chassis -> ChassisFields(scope)
        is RobotElement.Caster, is RobotElement.Corner -> PlaceRows(scope, element)
    }
}

/** How far ahead of the pen an element is, and how far to its left. */
@Composable
internal fun PlaceRows(scope: RobotScope, element: RobotElement) {
    val at = scope.robot.placeOf(element) ?: return
    Centimetres(scope, RobotTexts::ahead, at.x, RobotLimits.COORDINATES, "robot-x") {
        scope.make(RobotEdit.Nudge(it - at.x, 0.0))
    }
    Centimetres(scope, RobotTexts::leftwards, at.y, RobotLimits.COORDINATES, "robot-y") {
        scope.make(RobotEdit.Nudge(0.0, it - at.y))
    }
}

@Composable
internal fun Centimetres(
    scope: RobotScope,
    title: Label,
    value: Double,
    range: ClosedFloatingPointRange<Double>,
    tag: String,
    step: Double = RobotSnapping.CENTIMETRES,
    onChange: (Double) -> Unit,
) = NumberRow(title(spoken), shown(value), range, tag, onChange, scope::settle, step, unit = "cm")

/** The track of the penbot has more digits than anybody wants to read. */
internal fun shown(value: Double): Double = round(value * HUNDREDTHS) / HUNDREDTHS

@Composable
private fun WheelFields(scope: RobotScope) {
    val drive = scope.robot.drive
    val change = { what: String, changed: Drive -> scope.change(scope.robot.copy(drive = changed), what) }
    val atOnce = { changed: Drive -> scope.changeAtOnce(scope.robot.copy(drive = changed)) }
    val parameters = RobotParameters.of(scope.robot)
    HelpText(
        RobotTexts.speed(
            spoken,
            written(round(parameters.topSpeed)),
            written(round(parameters.wheelCircumference * TENTHS) / TENTHS),
        ),
    )
    val diameters = RobotLimits.WHEEL_DIAMETERS
    Centimetres(scope, RobotTexts::wheelDiameter, drive.wheelDiameter, diameters, "robot-diameter") {
        change("diameter", drive.copy(wheelDiameter = it))
    }
    Centimetres(scope, RobotTexts::tyre, drive.wheelWidth, RobotLimits.WHEEL_WIDTHS, "robot-tyre") {
        change("tyre", drive.copy(wheelWidth = it))
    }
    Centimetres(scope, RobotTexts::track, drive.track, RobotLimits.TRACKS, "robot-track") {
        change("track", drive.copy(track = it))
    }
    MotorChips(RobotTexts::leftMotor, drive.left, "robot-left-motor") { atOnce(drive.copy(left = it)) }
    MotorChips(RobotTexts::rightMotor, drive.right, "robot-right-motor") { atOnce(drive.copy(right = it)) }
    NumberRow(
        RobotTexts.gear(spoken),
        shown(drive.gear),
        RobotLimits.GEARS,
        "robot-gear",
        { change("gear", drive.copy(gear = it)) },
        scope::settle,
        step = 0.5,
    )
    NumberRow(
        RobotTexts.grip(spoken),
        drive.tyreFriction,
        RobotLimits.TYRE_FRICTIONS,
        "robot-grip",
        { change("grip", drive.copy(tyreFriction = it)) },
        scope::settle,
        step = 0.1,
    )
    SwitchRow(RobotTexts.reversed(spoken), drive.reversed, "robot-reversed") {
        atOnce(drive.copy(reversed = it))
    }
}

@Composable
private fun MassFields(scope: RobotScope) {
    val chassis = scope.robot.chassis
    HelpText(RobotTexts.massSide(spoken))
    NumberRow(
        RobotTexts.massKg(spoken),
        chassis.mass,
        RobotLimits.MASSES,
        "robot-mass",
        { scope.changeChassis("mass", chassis.copy(mass = it)) },
        scope::settle,
        step = 0.1,
        unit = "kg",
    )
    Centimetres(scope, RobotTexts::ahead, chassis.massAt.x, RobotLimits.COORDINATES, "robot-x") {
        scope.changeChassis("mass place", chassis.copy(massAt = Point(it, chassis.massAt.y)))
    }
}

@Composable
private fun ChassisFields(scope: RobotScope) {
    val chassis = scope.robot.chassis
    val corners = chassis.outline
    val (back, front) = corners.minOf { it.x } to corners.maxOf { it.x }
    val (right, left) = corners.minOf { it.y } to corners.maxOf { it.y }
    val sides = RobotLimits.OUTLINE_SIDES
    Centimetres(scope, RobotTexts::length, front - back, sides, "robot-length") { length ->
        if (front > back) {
            val scaled = corners.map { Point(back + (it.x - back) * length / (front - back), it.y) }
            scope.changeChassis("length", chassis.copy(outline = scaled))
        }
    }
    Centimetres(scope, RobotTexts::width, left - right, sides, "robot-width", step = 1.0) { width ->
        if (left > right) {
            val middle = (left + right) / 2
            val scaled = corners.map { Point(it.x, middle + (it.y - middle) * width / (left - right)) }
            scope.changeChassis("width", chassis.copy(outline = scaled))
        }
    }
    Centimetres(scope, RobotTexts::height, chassis.height, RobotLimits.HEIGHTS, "robot-height") {
        scope.changeChassis("height", chassis.copy(height = it))
    }
}

private fun RobotScope.changeChassis(what: String, chassis: Chassis) = change(robot.copy(chassis = chassis), what)

@Composable
internal fun MotorChips(title: Label, motor: MotorPort?, tag: String, onChoose: (MotorPort) -> Unit) =
    ChipRow(title(spoken), MotorPort.entries.map { it to it.name }, motor ?: MotorPort.B, tag, onChoose)

private const val TENTHS = 10.0
private const val HUNDREDTHS = 100.0
