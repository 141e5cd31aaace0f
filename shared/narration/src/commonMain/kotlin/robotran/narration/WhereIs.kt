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
        addAll(scene.goals(language))
        addAll(scene.around())
        addAll(scene.grounds())
        addAll(scene.others())
        add(scene.messages.pen(now.penDown))
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

    /** What the robot would meet first on each side, and how far away it is. */
    private val met: Map<RobotSide, Pair<Thing, Double>> = buildMap {
        for (side in RobotSide.entries) nearestIn(sweep(pose, side))?.let { put(side, it) }
    }

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

    /** What would stop the robot first on each side, and how far it is to the edge of the sheet on the others. */
    fun around(): List<String> {
        val things = met.entries.groupBy({ it.value.first }, { it.key to it.value.second }).map { (thing, sides) ->
            sides.singleOrNull()?.let { (side, free) -> told(side, thing, free) }
                ?: messages.around(
                    thing.kind,
                    thing.name,
                    sides.map { (side, free) ->
                        messages.toSide(side, centimetres(free))
                    },
                )
        }
        val edges = (RobotSide.entries - met.keys).mapNotNull { side ->
            sweep(pose, side).distanceToEdge(world.paper)?.let { messages.toSide(side, centimetres(it)) }
        }
        return things + listOfNotNull(edges.takeIf { it.isNotEmpty() }?.let(messages::edges))
    }

    /** What the robot would meet first if it turned to [point] and drove there; null if the way is free or ahead. */
    fun inTheWayTo(point: Point): String? {
        if (turnTo(point) == 0) return null
        val turned = Pose(pose.x, pose.y, pose.heading + pose.turnTo(point))
        val (thing, free) = nearestIn(sweep(turned, RobotSide.AHEAD)) ?: return null
        val isBefore = free + description.box.right < pose.distanceTo(point)
        return if (isBefore) messages.inTheWay(thing.kind, thing.name, centimetres(free)) else null
    }

    private fun sweep(from: Pose, side: RobotSide) = Sweep(from, side, description.box)

    private fun nearestIn(sweep: Sweep): Pair<Thing, Double>? {
        val met = bodies.mapNotNull { body -> sweep.distanceTo(body.outline)?.let { body.thing to it } }
        return met.minByOrNull { it.second }
    }

    private fun told(side: RobotSide, thing: Thing, free: Double) = if (free < TOUCHING) {
        messages.touching(side, thing.kind, thing.name)
    } else {
        messages.free(side, thing.kind, thing.name, centimetres(free))
    }

    /** What is under its pen and, if it has one, its light sensor; white paper is not told. */
    fun grounds(): List<String> {
        val seesFloor = description.parts.any { it is SensorPart && it.sensor in FLOOR_SENSORS }
        val eye = description.lineSensor.let { Direction(pose.heading).from(pose.point, it.x, it.y) }
        val pen = under(pose.point)
        val sensor = if (seesFloor) under(eye) else null
        if (pen != null && pen == sensor) return listOf(messages.underBoth(pen))
        return listOfNotNull(pen?.let(messages::under), sensor?.let(messages::underSensor))
    }

    /** Blocks, other robots and lamps: where each is, unless [around] tells it. */
    fun others(): List<String> {
        val things = bodies.filter { it.thing.kind == ThingKind.BLOCK || it.thing.kind == ThingKind.ROBOT }
        val near = things.mapNotNull { body ->
            val standing = body.robot?.let { session.robots[it].robot.pose.point }
            val place = standing ?: body.outline.bounds.run { Point((left + right) / 2, (bottom + top) / 2) }
            val side = when (turnTo(place)) {
                0 -> RobotSide.AHEAD
                HALF_TURN.toInt() -> RobotSide.BEHIND
                else -> null
            }
            if (met[side]?.first == body.thing) null else away(body.thing, place)
        }
        val lamps = world.lamps.zip(session.lamps) { lamp, now ->
            if (now.on) away(Thing(ThingKind.LAMP, lamp.name), now.place) else messages.lampOff(lamp.name)
        }
        return near.take(MAX_THINGS) + lamps.take(MAX_LAMPS)
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
        .filter { it.kind != GroundKind.PAPER && !(it.kind == GroundKind.TEMPLATE && isAtDrawing) }
        .takeIf { it.isNotEmpty() }
        ?.map { messages.ground(it.kind, it.name, it.tone) }

    private companion object {
        val FLOOR_SENSORS =
            setOf(SensorKind.LIGHT, SensorKind.RCX_LIGHT, SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR)

        /** In centimetres. */
        const val TOUCHING = 0.3
        const val MAX_THINGS = 5
        const val MAX_LAMPS = 3

        /** In degrees. */
        const val STRAIGHT = 2
    }
}
