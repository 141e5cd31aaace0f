package robotran.simulation.goal

import robotran.brick.state.RunState
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.RunMoment
import robotran.simulation.state.SessionState
import robotran.world.MovableBlock
import robotran.world.TouchKind
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Shape
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.centre
import robotran.world.geometry.length
import robotran.world.geometry.outline
import robotran.world.robot.footprint
import robotran.world.robot.lineSensor

/** A robot or block of a goal, by its index in the world. */
internal sealed interface Actor {
    val number: Int

    data class OfRobots(override val number: Int) : Actor

    data class OfBlocks(override val number: Int) : Actor
}

/**
 * The view of evaluators on a run at one moment.
 *
 * @property between what a program has done since the last moment, in its order with what other programs have done; null
 * for the moment itself.
 * @param lines the line that each robot's program is at, or was at last.
 */
internal class GoalScene(
    val state: SessionState,
    private val places: ObjectLocations,
    private val lines: List<RunState.Running?>,
    val between: ProgramEvent? = null,
) {
    /** Whether more than [seconds] of the run have passed; false for null. */
    fun isAfter(seconds: Int?): Boolean = seconds != null && state.milliseconds > seconds * MILLISECONDS_PER_SECOND

    fun robot(actor: Actor.OfRobots): RobotSnapshot? = state.robots.getOrNull(actor.number)

    /** The pen of a robot, the centre of a block; null if it is nowhere. */
    fun middle(actor: Actor): Point? = pose(actor)?.let { pose ->
        when (actor) {
            is Actor.OfRobots -> Point(pose.x, pose.y)
            is Actor.OfBlocks -> places.blockCentre(actor.number, pose)
        }
    }

    /** The outline of a robot or a block, seen from above; null if it is nowhere. */
    fun footprint(actor: Actor): Outline? = pose(actor)?.let { places.footprint(actor, it) }

    /** The point with which a robot follows a line; null if the robot is nowhere. */
    fun lightSensor(actor: Actor.OfRobots): Point? = pose(actor)?.let { places.lineSensor(actor, it) }

    /** How far the middle or, if [whole], any part of [actor] is outside [region]; null if it is nowhere. */
    fun distance(actor: Actor, region: Outline, whole: Boolean): Overhang? =
        if (whole) footprint(actor)?.overhang(region) else middle(actor)?.overhang(region)

    /**
     * This moment, with the line that the program of the robot is at, or was at last: a robot rolls on a little when
     * its program has ended. For a block, it is the program of the first robot.
     *
     * @param point the spot that mattered.
     */
    fun moment(actor: Actor, point: Point?): RunMoment {
        val robot = (actor as? Actor.OfRobots)?.number ?: 0
        val line = lines.getOrNull(robot)
        return RunMoment(
            state.milliseconds,
            point,
            line?.sourceLine ?: 0,
            line?.sourceFile,
            places.nameAmongRobots(robot),
        )
    }

    /** Where [actor] touches or nearly touches a thing of these [kinds]; null if there is none. */
    fun contact(actor: Actor.OfRobots, kinds: Set<TouchKind>): Contact? {
        val footprint = footprint(actor) as? Outline.Angular ?: return null
        return places.things(kinds, this, actor).map { (name, outline) ->
            val (place, distance) = footprint.nearestContact(outline)
            Contact(place, name, distance)
        }.minByOrNull { it.distance }
    }

    private fun pose(actor: Actor): Pose? = when (actor) {
        is Actor.OfRobots -> robot(actor)?.robot?.pose
        is Actor.OfBlocks -> state.blocks.getOrNull(actor.number)
    }
}

/**
 * A place where a robot touches a thing.
 *
 * @property name the name of the thing; null if it has none.
 * @property distance between the two, in centimetres; 0 if they overlap.
 */
internal class Contact(val place: Point, val name: String?, val distance: Double)

/** The locations of a world's objects, recomputed only when they have moved. */
internal class ObjectLocations(private val world: World, private val trigonometry: Trigonometry) {
    private val blocks = world.blocks.map { RestingBlock(it, trigonometry) }
    private val robots = world.robots.map { RobotPlan(it.description.footprint, it.description.lineSensor) }
    private val footprints = mutableMapOf<Actor, Pair<Pose, Outline>>()

    /** The robot or block named [name], or the first robot for null; null if there is none. */
    fun actor(name: String?): Actor? =
        robot(name) ?: world.blocks.indexOfFirst { it.name == name }.takeIf { it >= 0 }?.let(Actor::OfBlocks)

    /** The same for goals that only a robot can meet. */
    fun robot(name: String?): Actor.OfRobots? = if (name == null) {
        Actor.OfRobots(0)
    } else {
        world.robots.indexOfFirst { it.name == name }.takeIf { it >= 0 }?.let(Actor::OfRobots)
    }

    /** What tells the robot with the index [number] from others; null if it is the only one. */
    fun nameAmongRobots(number: Int): String? = world.robots.takeIf { it.size > 1 }?.getOrNull(number)?.name

    private fun outlineOf(wall: Wall): Outline {
        val along = length(wall.to.x - wall.from.x, wall.to.y - wall.from.y)
        val halfX = wall.thickness / 2 * if (along == 0.0) 1.0 else (wall.to.x - wall.from.x) / along
        val halfY = wall.thickness / 2 * if (along == 0.0) 0.0 else (wall.to.y - wall.from.y) / along
        return Outline.Angular(
            listOf(
                Point(wall.from.x - halfX + halfY, wall.from.y - halfY - halfX),
                Point(wall.to.x + halfX + halfY, wall.to.y + halfY - halfX),
                Point(wall.to.x + halfX - halfY, wall.to.y + halfY + halfX),
                Point(wall.from.x - halfX - halfY, wall.from.y - halfY + halfX),
            ),
        )
    }

    fun region(shape: Shape): Outline = shape.outline(trigonometry)

    fun blockCentre(number: Int, moved: Pose): Point = blocks[number].centre.let {
        Point(it.x + moved.x, it.y + moved.y)
    }

    fun footprint(actor: Actor, pose: Pose): Outline {
        val known = footprints[actor]
        if (known != null && known.first == pose) return known.second
        return when (actor) {
            is Actor.OfRobots -> Outline.Angular(robots[actor.number].corners.map { ahead(pose, it.x, it.y) })
            is Actor.OfBlocks -> movedBlock(actor.number, pose)
        }.also { footprints[actor] = pose to it }
    }

    /** The outlines of all things of these [kinds], with their names, apart from [actor]. */
    fun things(kinds: Set<TouchKind>, scene: GoalScene, actor: Actor): List<Pair<String?, Outline>> = kinds.flatMap {
        when (it) {
            TouchKind.WALLS -> world.walls.map { wall -> null to outlineOf(wall) }
            TouchKind.BARRIERS -> world.barriers.map { barrier -> barrier.name to region(barrier.shape) }

            TouchKind.BLOCKS -> world.blocks.mapIndexedNotNull { number, block ->
                scene.footprint(Actor.OfBlocks(number))?.let { outline -> block.name to outline }
            }

            TouchKind.ROBOTS -> world.robots.mapIndexedNotNull { number, robot ->
                val other = Actor.OfRobots(number)
                if (other == actor) null else scene.footprint(other)?.let { outline -> robot.name to outline }
            }
        }
    }

    /** The point with which a robot at [pose] follows a line. */
    fun lineSensor(actor: Actor.OfRobots, pose: Pose): Point =
        robots[actor.number].lineSensor.let { ahead(pose, it.x, it.y) }

    /** The point on a robot at [pose] at these distances in front of its pen and to the left of it. */
    fun ahead(pose: Pose, forwards: Double, leftwards: Double): Point {
        val cosine = trigonometry.cosine(pose.heading * RADIANS_PER_DEGREE)
        val sine = trigonometry.sine(pose.heading * RADIANS_PER_DEGREE)
        return Point(pose.x + forwards * cosine - leftwards * sine, pose.y + forwards * sine + leftwards * cosine)
    }

    private fun movedBlock(number: Int, moved: Pose): Outline {
        val block = blocks[number]
        val centre = blockCentre(number, moved)
        return when (val outline = block.outline) {
            is Outline.Round -> Outline.Round(centre, outline.radius)

            is Outline.Angular -> Outline.Angular(
                outline.corners.map {
                    ahead(
                        Pose(centre.x, centre.y, moved.heading),
                        it.x - block.centre.x,
                        it.y - block.centre.y,
                    )
                },
            )
        }
    }
}

/**
 * What a goal needs of the construction of a robot.
 *
 * @property corners of its footprint, counter-clockwise.
 */
private class RobotPlan(val corners: List<Point>, val lineSensor: Point)

/** A block at its initial pose. */
private class RestingBlock(block: MovableBlock, trigonometry: Trigonometry) {
    val outline = block.shape.outline(trigonometry)
    val centre: Point = block.shape.centre
}

internal const val MILLISECONDS_PER_SECOND = 1000L
