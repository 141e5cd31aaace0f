package robotran.world.file

import robotran.json.JsonCursor
import robotran.json.messages.JsonMessages
import robotran.json.nearestDecimal
import robotran.world.Paper
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.WorldLimits
import robotran.world.geometry.Pose
import robotran.world.geometry.normalHeading
import robotran.world.messages.told
import robotran.world.messages.toldOfRobot

internal fun readRobot(place: JsonCursor, paper: Paper) = RobotPlacement(
    start = readStart(place.member("start"), paper),
    name = place.optional("name")?.text(WorldLimits.MAXIMUM_NAME_CHARACTERS) ?: FIRST_ROBOT,
    colour = place.optional("colour")?.choice(COLOURS) ?: RobotColour.YELLOW,
    description = readBuild(place),
    lightFacing = place.optional("lightSensor")?.choice(FACINGS),
    beacon = place.optional("beacon")?.number(0.0..WorldLimits.MAXIMUM_BRIGHTNESS) ?: 0.0,
    program = place.optional("program")?.let(::readProgram),
    draft = place.optional("draft")?.let { readDescription(it, mayBeImpossible = true) },
    unknown = unknownOf(place),
)

private fun readStart(place: JsonCursor, paper: Paper): Pose {
    val x = place.member("x").number(WorldLimits.COORDINATES)
    val y = place.member("y").number(WorldLimits.COORDINATES)
    if (!paper.contains(x, y)) place.refuse(told { besidePaper() })
    // The sum with half a turn may have more digits than a file keeps.
    return Pose(x, y, nearestDecimal(normalHeading(place.member("heading").number(WorldLimits.ANGLES))))
}

/** A ready robot, a robot of its own, or a penbot with sensors on its ports. */
private fun readBuild(place: JsonCursor): RobotDescription {
    val ports = place.optional("ports")
    val robot = place.optional("robot") ?: return ports?.let { ReadyRobots.penbotWith(readPorts(it)) }
        ?: ReadyRobots.RCX_PENBOT
    ports?.refuseInSentence(toldOfRobot { robotAndPorts() })
    return if (robot.textOrNull() != null) readyRobot(robot) else readDescription(robot)
}

private fun readPorts(place: JsonCursor): List<List<PortSensor>> {
    (place.names - PORTS).firstOrNull()?.let { name -> place.refuse(told { noSuchPort(name) }) }
    return PORTS.map { port -> place.optional(port)?.let(::readPort).orEmpty() }
}

private fun readPort(place: JsonCursor): List<PortSensor> {
    if (place.textOrNull() != null) return listOf(place.choice(SENSORS))
    val sensors = place.items(0..WorldLimits.MAXIMUM_SENSORS_PER_PORT).map { it.choice(SENSORS) }
    if (sensors.toSet().size < sensors.size) place.refuse(told { sensorTwice() })
    return sensors
}

private fun readProgram(place: JsonCursor): String =
    place.items(1..WorldLimits.MAXIMUM_PROGRAM_LINES).joinToString("\n", transform = ::readProgramLine)

/** A program line may be blank and start with tabs. */
private fun readProgramLine(place: JsonCursor): String {
    val line = place.longText(WorldLimits.MAXIMUM_PROGRAM_LINE_CHARACTERS)
    if (line.any { it.isISOControl() && it != '\t' }) place.refuse { JsonMessages.of(it).mustBeOneOrdinaryLine() }
    return line
}

/** Default name of the only robot of a world. */
const val FIRST_ROBOT = "yellow"
