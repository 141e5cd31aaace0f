package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.decimal
import robotran.json.jsonObject
import robotran.world.Light
import robotran.world.PortSensor
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.penbotPorts

/** Lists of lines of text, written one item per line. */
val MULTILINE_LISTS: Set<String> = setOf("program", "rows")

/** [world] as JSON, in the newest version of the format. */
fun elementOf(world: World): JsonObject = jsonObject(world.unknown.members) {
    text("format", WORLD_FORMAT)
    number("version", WORLD_VERSION)
    text("title", world.title)
    text("task", world.task, default = "")
    put(
        "paper",
        jsonObject(world.paper.unknown.members) {
            number("width", world.paper.width)
            number("height", world.paper.height)
        },
    )
    list("robots", world.robots, ::elementOf)
    list("walls", world.walls, ::elementOf)
    list("barriers", world.barriers, ::elementOf)
    list("blocks", world.blocks, ::elementOf)
    list("marks", world.marks, ::elementOf)
    list("lamps", world.lamps, ::elementOf)
    number("light", world.ambientLight, default = Light.DIM_ROOM)
    number("temperature", world.temperature, default = World.ROOM_TEMPERATURE)
    put(
        "template",
        world.template?.let { template ->
            jsonObject(template.unknown.members) { put("strokes", JsonArray(template.strokes.map(::points))) }
        },
    )
    list("goals", world.goals, ::elementOf)
    number("timeLimit", world.timeLimit, default = World.DEFAULT_TIME_LIMIT)
    number("realism", world.realism, default = 0.0)
    number("seed", world.seed, default = 1)
}

private fun elementOf(robot: RobotPlacement) = jsonObject(robot.unknown.members) {
    text("name", robot.name, default = FIRST_ROBOT)
    text("colour", wordFor(robot.colour), default = wordFor(RobotColour.YELLOW))
    put("start", elementOf(robot.start))
    val ports = robot.description.penbotPorts
    if (ports == null) {
        put("robot", elementOf(robot.description))
    } else if (ports != RobotPlacement.PENBOT_PORTS) {
        put("ports", elementOf(ports))
    }
    text("lightSensor", robot.lightFacing?.let(::wordFor))
    number("beacon", robot.beacon, default = 0.0)
    put("program", robot.program?.let { program -> JsonArray(program.lines().map(::JsonPrimitive)) })
    robot.draft?.let { draft -> put("draft", jsonObject(draft.unknown.members) { describe(draft) }) }
}

private fun elementOf(start: Pose) = jsonObject {
    number("x", start.x)
    number("y", start.y)
    number("heading", start.heading)
}

private fun elementOf(ports: List<List<PortSensor>>) = jsonObject {
    PORTS.zip(ports) { port, sensors ->
        val words = sensors.map { JsonPrimitive(wordFor(it)) }
        if (words.isNotEmpty()) put(port, words.singleOrNull() ?: JsonArray(words))
    }
}

internal fun point(point: Point): JsonElement = JsonArray(listOf(decimal(point.x), decimal(point.y)))

internal fun points(points: List<Point>): JsonElement = JsonArray(points.map(::point))
