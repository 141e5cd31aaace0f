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
import robotran.world.messages.reason
import robotran.world.messages.robotReason

internal fun readRobot(cursor: JsonCursor, paper: Paper) = RobotPlacement(
    start = readStart(cursor.member("start"), paper),
    name = cursor.optional("name")?.text(WorldLimits.MAXIMUM_NAME_CHARACTERS) ?: FIRST_ROBOT,
    colour = cursor.optional("colour")?.choice(COLOURS) ?: RobotColour.YELLOW,
    description = readBuild(cursor),
    lightFacing = cursor.optional("lightSensor")?.choice(FACINGS),
    beacon = cursor.optional("beacon")?.number(0.0..WorldLimits.MAXIMUM_BRIGHTNESS) ?: 0.0,
    program = cursor.optional("program")?.let(::readProgram),
    draft = cursor.optional("draft")?.let { readDescription(it, mayBeImpossible = true) },
    unknown = unknownOf(cursor),
)

private fun readStart(cursor: JsonCursor, paper: Paper): Pose {
    val x = cursor.member("x").number(WorldLimits.COORDINATES)
    val y = cursor.member("y").number(WorldLimits.COORDINATES)
    if (!paper.contains(x, y)) cursor.refuse(reason { besidePaper() })
    // The sum with half a turn may have more digits than a file keeps.
    return Pose(x, y, nearestDecimal(normalHeading(cursor.member("heading").number(WorldLimits.ANGLES))))
}

/** A ready robot, a robot of its own, or a penbot with sensors on its ports. */
private fun readBuild(cursor: JsonCursor): RobotDescription {
    val ports = cursor.optional("ports")
    val robot = cursor.optional("robot") ?: return ports?.let { ReadyRobots.penbotWith(readPorts(it)) }
        ?: ReadyRobots.RCX_PENBOT
    ports?.refuseInSentence(robotReason { robotAndPorts() })
    return if (robot.textOrNull() != null) readyRobot(robot) else readDescription(robot)
}

private fun readPorts(cursor: JsonCursor): List<List<PortSensor>> {
    (cursor.names - PORTS).firstOrNull()?.let { name -> cursor.refuse(reason { noSuchPort(name) }) }
    return PORTS.map { port -> cursor.optional(port)?.let(::readPort).orEmpty() }
}

private fun readPort(cursor: JsonCursor): List<PortSensor> {
    if (cursor.textOrNull() != null) return listOf(cursor.choice(SENSORS))
    val sensors = cursor.items(0..WorldLimits.MAXIMUM_SENSORS_PER_PORT).map { it.choice(SENSORS) }
    if (sensors.toSet().size < sensors.size) cursor.refuse(reason { sensorTwice() })
    return sensors
}

private fun readProgram(cursor: JsonCursor): String =
    cursor.items(1..WorldLimits.MAXIMUM_PROGRAM_LINES).joinToString("\n", transform = ::readProgramLine)

/** A program line may be blank and start with tabs. */
private fun readProgramLine(cursor: JsonCursor): String {
    val line = cursor.longText(WorldLimits.MAXIMUM_PROGRAM_LINE_CHARACTERS)
    if (line.any { it.isISOControl() && it != '\t' }) cursor.refuse { JsonMessages.of(it).mustBeOneOrdinaryLine() }
    return line
}

/** Default name of the only robot of a world. */
const val FIRST_ROBOT = "yellow"
