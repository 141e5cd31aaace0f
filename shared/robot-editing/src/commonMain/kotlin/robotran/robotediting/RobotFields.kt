package robotran.robotediting

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.Option
import robotran.editing.RobotTexts
import robotran.editing.TextSpec
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.editing.chips
import robotran.editing.written
import robotran.world.Chassis
import robotran.world.Drive
import robotran.world.PenMount
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.geometry.Point
import robotran.world.robot.RobotParameters
import kotlin.math.round

/** The fields of an element in display order. */
fun RobotEditing.fieldsOf(element: RobotElement): List<Field<RobotEdit>> =
    if (element == RobotElement.Wheels) robot.wheelFields() + robot.measureFields(driven) else robot.fieldsOf(element)

private fun RobotDescription.fieldsOf(element: RobotElement): List<Field<RobotEdit>> = when (element) {
    is RobotElement.Part -> partFields(element.number)
    RobotElement.Wheels -> wheelFields()

    RobotElement.Pen -> listOf(
        Field.Help(RobotTexts::penHelp),
        motor("robot-pen-motor", RobotTexts::motor, pen?.motor) { copy(pen = PenMount(it)) },
    )

    RobotElement.Brick -> buggyFields() + placeFields(element) +
        Field.Flag("robot-brick-turned", RobotTexts::brickTurned, brickAt.turned) {
            RobotEdit.Change(copy(brickAt = brickAt.copy(turned = it)))
        }

    RobotElement.Mass -> massFields()
    RobotElement.Chassis -> chassisFields()
    is RobotElement.Caster, is RobotElement.Corner -> placeFields(element)
}

/** The fields of the robot as a whole. */
fun RobotDescription.wholeFields(): List<Field<RobotEdit>> = listOf(
    Field.Text("robot-title", WorldEditorTexts::name, title, TextSpec(RobotLimits.MAXIMUM_TITLE_CHARACTERS)) {
        RobotEdit.Change(copy(title = it), "title")
    },
    chips(
        "robot-brick",
        RobotTexts::brick,
        BrickKind.entries.map { kind ->
            Option(kind, { kind.label })
        },
        brick,
    ) { kind -> RobotEdit.Change(withBrick(kind)).takeIf { kind != brick } },
) + buggyFields().take(1)

/** The same robot with another brick. On a buggy another micro:bit changes nothing else; its wiring says where motors are. */
private fun RobotDescription.withBrick(kind: BrickKind): RobotDescription {
    if (kind.isOnBuggy && buggy != null) return copy(brick = kind)
    val usual = ReadyRobots.defaultOf(kind)
    val changed = copy(brick = kind, buggy = usual.buggy, base = usual.base)
    if (!kind.isOnBuggy) return changed
    return changed.copy(
        drive = drive.copy(left = usual.drive.left, right = usual.drive.right),
        pen = if (pen == null) null else usual.pen,
    )
}

/** How far ahead of the pen an element is, and how far to its left. */
internal fun RobotDescription.placeFields(element: RobotElement): List<Field<RobotEdit>> {
    val at = placeOf(element) ?: return emptyList()
    return listOf(
        centimetres("robot-x", RobotTexts::ahead, at.x, RobotLimits.COORDINATES) { RobotEdit.Nudge(it - at.x, 0.0) },
        centimetres("robot-y", RobotTexts::leftwards, at.y, RobotLimits.COORDINATES) {
            RobotEdit.Nudge(0.0, it - at.y)
        },
    )
}

internal fun centimetres(
    tag: String,
    label: Words,
    value: Double,
    range: ClosedRange<Double>,
    step: Double = RobotSnapping.CENTIMETRES,
    with: (Double) -> RobotEdit?,
): Field<RobotEdit> = Field.Number(tag, label, shown(value), NumberSpec(range, step = step, unit = "cm"), with)

/** The track of the penbot has more digits than anybody wants to read. */
internal fun shown(value: Double): Double = round(value * HUNDREDTHS) / HUNDREDTHS

private fun RobotDescription.wheelFields(): List<Field<RobotEdit>> = with(drive) {
    val parameters = RobotParameters.of(this@wheelFields)
    val speed = written(round(parameters.topSpeed))
    val circumference = written(round(parameters.wheelCircumference * TENTHS) / TENTHS)
    val change = { what: String?, changed: Drive -> RobotEdit.Change(copy(drive = changed), what) }
    listOf(
        Field.Help { RobotTexts.speed(it, speed, circumference) },
        centimetres("robot-diameter", RobotTexts::wheelDiameter, wheelDiameter, RobotLimits.WHEEL_DIAMETERS) {
            change("diameter", copy(wheelDiameter = it))
        },
        centimetres("robot-tyre", RobotTexts::tyre, wheelWidth, RobotLimits.WHEEL_WIDTHS) {
            change("tyre", copy(wheelWidth = it))
        },
        centimetres("robot-track", RobotTexts::track, track, RobotLimits.TRACKS) { change("track", copy(track = it)) },
    ) + wheelMotors() + listOf(
        Field.Number("robot-gear", RobotTexts::gear, shown(gear), GEAR) { change("gear", copy(gear = it)) },
        Field.Number("robot-grip", RobotTexts::grip, tyreFriction, GRIP) { change("grip", copy(tyreFriction = it)) },
        Field.Flag("robot-reversed", RobotTexts::reversed, reversed) { change(null, copy(reversed = it)) },
    )
}

/** Which motor drives which wheel. On a buggy its wiring says so. */
private fun RobotDescription.wheelMotors(): List<Field<RobotEdit>> = if (brick.isOnBuggy) {
    emptyList()
} else {
    listOf(
        motor("robot-left-motor", RobotTexts::leftMotor, drive.left) { copy(drive = drive.copy(left = it)) },
        motor("robot-right-motor", RobotTexts::rightMotor, drive.right) { copy(drive = drive.copy(right = it)) },
    )
}

private fun RobotDescription.massFields(): List<Field<RobotEdit>> = listOf(
    Field.Help(RobotTexts::massSide),
    Field.Number("robot-mass", RobotTexts::massKg, chassis.mass, MASS) { changed("mass", chassis.copy(mass = it)) },
    centimetres("robot-x", RobotTexts::ahead, chassis.massAt.x, RobotLimits.COORDINATES) {
        changed("mass place", chassis.copy(massAt = Point(it, chassis.massAt.y)))
    },
)

private fun RobotDescription.chassisFields(): List<Field<RobotEdit>> {
    val corners = chassis.outline
    val (back, front) = corners.minOf { it.x } to corners.maxOf { it.x }
    val (right, left) = corners.minOf { it.y } to corners.maxOf { it.y }
    val sides = RobotLimits.OUTLINE_SIDES
    return listOf(
        centimetres("robot-length", RobotTexts::length, front - back, sides) { length ->
            val scaled = corners.map { Point(back + (it.x - back) * length / (front - back), it.y) }
            changed("length", chassis.copy(outline = scaled)).takeIf { front > back }
        },
        centimetres("robot-width", RobotTexts::width, left - right, sides, step = 1.0) { width ->
            val middle = (left + right) / 2
            val scaled = corners.map { Point(it.x, middle + (it.y - middle) * width / (left - right)) }
            changed("width", chassis.copy(outline = scaled)).takeIf { left > right }
        },
        centimetres("robot-height", RobotTexts::height, chassis.height, RobotLimits.HEIGHTS) {
            changed("height", chassis.copy(height = it))
        },
    )
}

private fun RobotDescription.changed(what: String, chassis: Chassis) = RobotEdit.Change(copy(chassis = chassis), what)

private fun RobotDescription.motor(
    tag: String,
    label: Words,
    motor: MotorPort?,
    with: (MotorPort) -> RobotDescription,
) = chips(tag, label, brick.motorPorts.map { port -> Option(port, { port.name }) }, motor ?: MotorPort.B) {
    RobotEdit.Change(with(it))
}

private const val TENTHS = 10.0
private const val HUNDREDTHS = 100.0
private val GEAR = NumberSpec(RobotLimits.GEARS, step = 0.5)
private val GRIP = NumberSpec(RobotLimits.TYRE_FRICTIONS, step = 0.1)
private val MASS = NumberSpec(RobotLimits.MASSES, step = 0.1, unit = "kg")
