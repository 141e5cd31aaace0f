package robotran.robotediting

import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.brick.kind.WheelTrim
import robotran.brick.sensors.SensorKind
import robotran.editing.Field
import robotran.editing.Option
import robotran.editing.RobotTexts
import robotran.editing.Words
import robotran.editing.chips
import robotran.world.BuggyMount
import robotran.world.Facing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.partFor

/** Which buggy a micro:bit is on, and the pins of a plain one. Empty for another brick. */
internal fun RobotDescription.buggyFields(): List<Field<RobotEdit>> {
    val buggy = buggy ?: return emptyList()
    val kind = chips(
        "robot-buggy",
        RobotTexts::buggy,
        BuggyKind.entries.map { kind -> Option(kind, { kind.label }) },
        buggy.kind,
    ) { chosen -> RobotEdit.Change(onBuggy(chosen)).takeIf { chosen != buggy.kind } }
    if (buggy.kind != BuggyKind.PLAIN) return listOf(kind)
    val pins = buggy.pins ?: BuggyPins.SERVOS
    return listOf(kind, Field.Help(RobotTexts::pinsHelp), driveField(pins)) + wheelPins(pins) + sensorPins(pins) +
        penPin(pins)
}

/** The ready robot with this buggy, with the brick of this one. */
private fun RobotDescription.onBuggy(kind: BuggyKind): RobotDescription = ReadyRobots.on(kind).copy(brick = brick)

private fun RobotDescription.driveField(pins: BuggyPins): Field<RobotEdit> = chips(
    "robot-pins-drive",
    RobotTexts::pinsDrive,
    listOf(Option(PlainDrive.SERVOS, RobotTexts::pinsServos), Option(PlainDrive.BRIDGE, RobotTexts::pinsBridge)),
    pins.drive,
) { drive ->
    val free = BuggyPins.USABLE - pins.all.toSet()
    val changed = when (drive) {
        pins.drive -> pins
        PlainDrive.SERVOS -> pins.copy(drive = drive, left = pins.left.take(1), right = pins.right.take(1))

        PlainDrive.BRIDGE -> if (free.size < 2) {
            pins
        } else {
            pins.copy(drive = drive, left = pins.left + free[0], right = pins.right + free[1])
        }
    }
    RobotEdit.Change(withPins(changed)).takeIf { changed != pins }
}

private fun RobotDescription.wheelPins(pins: BuggyPins): List<Field<RobotEdit>> {
    fun List<Int>.with(place: Int, pin: Int) = mapIndexed { index, old -> if (index == place) pin else old }
    val names = listOf(RobotTexts::pinAhead, RobotTexts::pinBack)
    val hasTwo = pins.drive == PlainDrive.BRIDGE
    val left = pins.left.mapIndexed { place, pin ->
        val label: Words = { if (hasTwo) "${RobotTexts.pinLeft(it)}, ${names[place](it)}" else RobotTexts.pinLeft(it) }
        pinField("robot-pin-left-${place + 1}", label, pins, pin) { pins.copy(left = pins.left.with(place, it ?: pin)) }
    }
    val right = pins.right.mapIndexed { place, pin ->
        val label: Words = {
            if (hasTwo) "${RobotTexts.pinRight(it)}, ${names[place](it)}" else RobotTexts.pinRight(it)
        }
        pinField("robot-pin-right-${place + 1}", label, pins, pin) {
            pins.copy(right = pins.right.with(place, it ?: pin))
        }
    }
    return left + right
}

private fun RobotDescription.sensorPins(pins: BuggyPins): List<Field<RobotEdit>> {
    val lines = List(minOf(pins.lines.size + 1, BuggyPins.MOST_LINES)) { place ->
        val label: Words = { RobotTexts.pinLine(it, place + 1) }
        pinField("robot-pin-line-${place + 1}", label, pins, pins.lines.getOrNull(place), mayBeNone = true) { pin ->
            val others = pins.lines.filterIndexed { index, _ -> index != place }
            pins.copy(lines = if (pin == null) others else others.take(place) + pin + others.drop(place))
        }
    }
    val dark = Field.Flag("robot-pins-dark", RobotTexts::pinsDark, pins.isDarkOne) {
        RobotEdit.Change(withPins(pins.copy(isDarkOne = it)))
    }
    val trigger = pinField("robot-pin-trigger", RobotTexts::pinTrigger, pins, pins.trigger, mayBeNone = true) {
        pins.copy(trigger = it, echo = if (it == null) null else pins.echo)
    }
    val echo =
        pinField("robot-pin-echo", RobotTexts::pinEcho, pins, pins.echo, mayBeNone = true, sharing = pins.trigger) {
            pins.copy(echo = it)
        }
    return lines + listOfNotNull(dark.takeIf { pins.lines.isNotEmpty() }, trigger, echo.takeIf { pins.trigger != null })
}

private fun RobotDescription.penPin(pins: BuggyPins): Field<RobotEdit> =
    pinField("robot-pin-pen", RobotTexts::pinPen, pins, pins.pen, mayBeNone = true) { pins.copy(pen = it) }

/** Offers the pins that nothing else uses. @param sharing one that may be used twice. */
private fun RobotDescription.pinField(
    tag: String,
    label: Words,
    pins: BuggyPins,
    now: Int?,
    mayBeNone: Boolean = false,
    sharing: Int? = null,
    with: (Int?) -> BuggyPins,
): Field<RobotEdit> {
    val free = BuggyPins.USABLE.filter { it == now || it == sharing || it !in pins.all }
    val options = free.map { pin -> Option<Int?>(pin, { "P$pin" }) }
    val none = if (mayBeNone) listOf(Option<Int?>(null, RobotTexts::pinNone)) else emptyList()
    return chips(tag, label, none + options, now) { pin ->
        RobotEdit.Change(withPins(with(pin))).takeIf { pin != now }
    }
}

/** The same robot with these pins, and with the sensors that they are for. */
internal fun RobotDescription.withPins(pins: BuggyPins): RobotDescription {
    val lines = partsOf(SensorKind.LIGHT)
    val front = chassis.outline.maxOf { it.x }
    val first = (pins.lines.size - 1) * LINES_APART / 2
    val wanted: List<RobotPart> = List(pins.lines.size) { number ->
        lines.getOrNull(number)?.on(number + 1) ?: partFor(SensorKind.LIGHT, number + 1).let { part ->
            val place = Point(front - LINES_BEHIND, first - number * LINES_APART)
            (part as SensorPart).copy(at = place, facing = Facing.Down)
        }
    }
    val port = pins.lines.size + 1
    val sonar = if (pins.trigger == null) {
        null
    } else {
        partsOf(SensorKind.ULTRASONIC).firstOrNull()?.on(port) ?: partFor(SensorKind.ULTRASONIC, port)
    }
    return copy(
        buggy = BuggyMount(BuggyKind.PLAIN, buggy?.trim ?: WheelTrim.NONE, pins),
        parts =
            wanted + listOfNotNull(sonar),
    )
}

private fun RobotDescription.partsOf(kind: SensorKind) = parts.filter { it.kind == kind }

private const val LINES_APART = 1.2
private const val LINES_BEHIND = 1.5
