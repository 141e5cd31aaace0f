package robotran.narration

import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.simulation.state.SessionState
import robotran.world.SensorPart
import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.robot.box
import robotran.world.robot.lineSensor
import kotlin.math.abs

/**
 * Where the robot with the index [robot] is and looks, what is around and under it, and where the goals are, in short
 * sentences of which each stands for itself. What is ahead, beside and behind counts from the robot's edge there, all
 * else from the point between its wheels.
 */
fun whereIs(robot: Int, world: World, session: SessionState, language: Language): List<String> {
    val placed = world.robots.getOrNull(robot) ?: return emptyList()
    val now = session.robots.getOrNull(robot)?.robot ?: return emptyList()
    val scene = RobotScene(robot, world, session, PlaceMessages.of(language))
    return buildList {
        add(scene.place(placed.name.takeIf { world.robots.size > 1 }))
        add(scene.looks())
        add(scene.messages.pen(now.penDown))
        addAll(RobotSide.entries.mapNotNull(scene::aside))
        addAll(scene.grounds())
        addAll(scene.others())
        addAll(scene.goals(language))
    }
}

/** What the robot with the index [robot] has around it. */
internal class RobotScene(
    private val robot: Int,
    val world: World,
    val session: SessionState,
    val messages: PlaceMessages,
) {
    private val description = world.robots[robot].description
    val pose: Pose = session.robots[robot].robot.pose
    private val bodies = bodiesOf(world, session).filter { it.robot != robot }

    fun place(who: String?): String {
        val paper = world.paper
        onSheet(pose.point, paper)?.let { return messages.place(who, centimetres(it.x), centimetres(it.y)) }
        val beyond = listOf(
            SheetSide.RIGHT to pose.x - paper.width,
            SheetSide.UP to pose.y - paper.height,
            SheetSide.LEFT to -pose.x,
            SheetSide.DOWN to -pose.y,
        ).maxBy { it.second }
        return messages.besideSheet(who, centimetres(beyond.second), beyond.first)
    }

    fun looks(): String = sheetDirection(pose.heading).let { messages.looks(it.to, it.degrees, it.aside) }

    /** What would stop the robot first if it went to [side], or the edge of the sheet; null for nothing. */
    fun aside(side: RobotSide): String? {
        val sweep = Sweep(pose, side, description.box)
        val met = bodies.mapNotNull { body -> sweep.distanceTo(body.outline)?.let { body.thing to it } }
        val edge = sweep.distanceToEdge(world.paper)?.let { Thing(ThingKind.EDGE) to it }
        val (thing, free) = (met + listOfNotNull(edge)).minByOrNull { it.second } ?: return null
        if (free < TOUCHING) return messages.touching(side, thing.kind, thing.name)
        return messages.free(side, thing.kind, thing.name, centimetres(free))
    }

    /** What is under its pen and, if it has one, its light sensor; white paper is not told. */
    fun grounds(): List<String> {
        val seesFloor = description.parts.any { it is SensorPart && it.sensor in FLOOR_SENSORS }
        val eye = description.lineSensor.let { Direction(pose.heading).from(pose.point, it.x, it.y) }
        return listOfNotNull(
            under(pose.point)?.let(messages::under),
            if (seesFloor) under(eye)?.let(messages::underSensor) else null,
        )
    }

    /** Blocks, other robots and lamps: where each is. */
    fun others(): List<String> {
        val things = bodies.filter { it.thing.kind == ThingKind.BLOCK || it.thing.kind == ThingKind.ROBOT }
        val near = things.map { body ->
            val standing = body.robot?.let { session.robots[it].robot.pose.point }
            away(body.thing, standing ?: body.outline.bounds.run { Point((left + right) / 2, (bottom + top) / 2) })
        }
        val lamps = world.lamps.zip(session.lamps) { lamp, now ->
            if (now.on) away(Thing(ThingKind.LAMP, lamp.name), now.place) else messages.lampOff(lamp.name)
        }
        return near.take(MOST_THINGS) + lamps.take(MOST_LAMPS)
    }

    /** By how much the robot has to turn to [point]; straight ahead and straight behind are 0 and 180. */
    fun turnTo(point: Point): Int {
        val degrees = wholeDegrees(pose.turnTo(point))
        return when {
            abs(degrees) <= STRAIGHT -> 0
            abs(degrees) >= HALF_TURN - STRAIGHT -> HALF_TURN.toInt()
            else -> degrees
        }
    }

    private fun away(thing: Thing, place: Point) =
        messages.away(thing.kind, thing.name, centimetres(pose.distanceTo(place)), turnTo(place))

    private fun under(point: Point): List<String>? = groundAt(world, session, point)
        .takeIf { it != PLAIN }
        ?.map { messages.ground(it.kind, it.name, it.tone) }

    private companion object {
        val PLAIN = listOf(Ground(GroundKind.PAPER))
        val FLOOR_SENSORS =
            setOf(SensorKind.LIGHT, SensorKind.RCX_LIGHT, SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR)

        /** In centimetres. */
        const val TOUCHING = 0.3
        const val MOST_THINGS = 5
        const val MOST_LAMPS = 3

        /** In degrees. */
        const val STRAIGHT = 2
    }
}
