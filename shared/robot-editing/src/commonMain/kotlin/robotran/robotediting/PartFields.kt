package robotran.robotediting

import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.Option
import robotran.editing.RobotTexts
import robotran.editing.chips
import robotran.language.Language
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.robot.BrickBuild
import robotran.world.robot.things

/** The figures of a bumper or a sensor. */
internal fun RobotDescription.partFields(number: Int): List<Field<RobotEdit>> {
    val part = things.getOrNull(number) ?: return emptyList()
    return listOf(portField(number)) + when (part) {
        is BumperPart -> bumperFields(number, part)
        is SensorPart -> sensorFields(number, part)

        is RotationPart -> listOf(
            chips("robot-wheel", RobotTexts::wheel, SIDES, part.wheel) { changed(number, null, part.copy(wheel = it)) },
        )

        else -> emptyList()
    }
}

/** Ports that something else is on say so, also the chosen one: on an RCX two things may share one. */
private fun RobotDescription.portField(number: Int): Field<RobotEdit> {
    val ports = (1..brick.inputPorts).map { port ->
        val other = thingsOn(port).firstOrNull { it != number }?.let { things[it] }
        Option<Int?>(
            port,
            { language ->
                if (other == null) "$port" else RobotTexts.portTaken(language, port, partWord(other)(language))
            },
        )
    }
    val options = listOf(Option<Int?>(null, RobotTexts::portNone)) + ports
    return chips("robot-port", RobotTexts::port, options, portsOf(number).firstOrNull()) { RobotEdit.SetPort(it) }
}

private fun RobotDescription.bumperFields(number: Int, part: BumperPart): List<Field<RobotEdit>> {
    val sides = listOf(Option<BumperSide?>(null, RobotTexts::noName)) + SIDES
    return listOf(directionField(part.direction) { changed(number, "direction", part.copy(direction = it)) }) +
        placeFields(RobotElement.Part(number)) +
        centimetres("robot-bumper-width", RobotTexts::bumperWidth, part.width, RobotLimits.BUMPER_WIDTHS) {
            changed(number, "width", part.copy(width = it))
        } +
        centimetres("robot-bumper-depth", RobotTexts::bumperDepth, part.depth, RobotLimits.BUMPER_DEPTHS) {
            changed(number, "depth", part.copy(depth = it))
        } +
        chips("robot-side", RobotTexts::side, sides, part.side) { changed(number, null, part.copy(side = it)) }
}

private fun RobotDescription.sensorFields(number: Int, part: SensorPart): List<Field<RobotEdit>> {
    val ahead = part.facing as? Facing.Ahead
    val motors = listOf(Option<MotorPort?>(null, RobotTexts::fixed)) +
        brick.motorPorts.map { port -> Option(port, { _: Language -> port.name }) }
    return listOfNotNull(
        if (part.sensor.seesSurfaces) facingField(number, part) else null,
        ahead?.let {
            directionField(it.direction) { to -> changed(number, "direction", part.copy(facing = Facing.Ahead(to))) }
        },
    ) + placeFields(RobotElement.Part(number)) + listOfNotNull(
        centimetres("robot-eye-height", RobotTexts::eyeHeight, part.height, RobotLimits.SENSOR_HEIGHTS) {
            changed(number, "height", part.copy(height = it))
        },
        chips("robot-turret", RobotTexts::turret, motors, part.turret) { changed(number, null, part.copy(turret = it)) }
            .takeIf { brick.hasMotorCounters || part.turret != null },
    )
}

private fun RobotDescription.facingField(number: Int, part: SensorPart): Field<RobotEdit> {
    val mayBeFree = part.sensor == SensorKind.LIGHT && BrickBuild.of(brick).hasShortForm
    val ahead = Facing.Ahead((part.facing as? Facing.Ahead)?.direction ?: 0.0)
    val facings = listOfNotNull(
        Option(Facing.Down, RobotTexts::looksDown),
        Option(ahead, RobotTexts::looksAhead),
        Option(Facing.Free, RobotTexts::looksFree).takeIf { part.facing == Facing.Free || mayBeFree },
    )
    return chips("robot-looks", RobotTexts::looks, facings, part.facing) { facing ->
        val height = if (facing is Facing.Ahead) maxOf(part.height, AHEAD_HEIGHT) else minOf(part.height, DOWN_HEIGHT)
        changed(number, null, part.copy(facing = facing, height = height))
    }
}

private fun directionField(direction: Double, with: (Double) -> RobotEdit?): Field<RobotEdit> =
    Field.Number("robot-direction", RobotTexts::direction, direction, DIRECTION, with)

/** Changes a bumper or sensor, unless that makes it the same as another one; see [RobotEdit.Change.what]. */
private fun RobotDescription.changed(number: Int, what: String?, part: RobotPart): RobotEdit? =
    withThing(number) { part }?.let { RobotEdit.Change(it, what?.let { "$what $number" }) }

private val SIDES = listOf(
    Option(BumperSide.LEFT, RobotTexts::sideLeft),
    Option(BumperSide.RIGHT, RobotTexts::sideRight),
)
private val DIRECTION = NumberSpec(-180.0..180.0, step = RobotSnapping.DEGREES, unit = "°")

/** In centimetres, where a sensor looks over the floor, and into it. */
private const val AHEAD_HEIGHT = 6.0
private const val DOWN_HEIGHT = 1.0
