package robotran.worldediting

import robotran.language.Language
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.MarkFigure
import robotran.world.NeedsTemplate
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.file.WorldFileResult
import robotran.world.file.edgesCross
import robotran.world.file.flat
import robotran.world.file.outline
import robotran.world.file.overlap
import robotran.world.file.readWorld
import robotran.world.file.writeWorld
import robotran.world.geometry.Outline
import robotran.world.geometry.Shape
import robotran.world.geometry.signedArea
import kotlin.math.abs

/** What has to be mended before a world can be kept or run in. */
sealed interface Trouble {
    /** What it is about; null for the world as a whole. */
    val thing: Thing?

    /** A robot would start in [other]. */
    data class InTheWay(override val thing: Thing, val other: Thing) : Trouble

    /** A robot would start beside the paper. */
    data class OffPaper(override val thing: Thing) : Trouble

    /** The edges of a polygon cross or touch each other, or there is hardly anything between them. */
    data class Tangled(override val thing: Thing) : Trouble

    /** A goal is about somebody who is not there. */
    data class NobodyThere(override val thing: Thing, val name: String) : Trouble

    /** A goal is about a line that is not there. */
    data class NoSuchLine(override val thing: Thing, val name: String) : Trouble

    /** A goal is about the drawing to be traced, and there is none. */
    data class NothingToTrace(override val thing: Thing) : Trouble

    /** Something that none of the others is, as the reader of world files says it. */
    data class Refused(private val world: World) : Trouble {
        override val thing: Thing? get() = null

        /** A sentence; empty if nothing is wrong with the world after all. */
        fun message(language: Language): String = (readWorld(writeWorld(world), language) as? WorldFileResult.Refused)?.message.orEmpty()
    }
}

/** What is to be seen at once of what is wrong with [world]. */
fun plainTroubles(world: World): List<Trouble> = startTroubles(world) + shapeTroubles(world) + goalTroubles(world)

/** All that is wrong with [world]: if this is empty, a file of it can be read again. */
fun troublesOf(world: World): List<Trouble> = plainTroubles(world).ifEmpty {
    when (readWorld(writeWorld(world))) {
        is WorldFileResult.Loaded -> emptyList()
        is WorldFileResult.Refused -> listOf(Trouble.Refused(world))
    }
}

private fun startTroubles(world: World): List<Trouble> {
    val robots = world.robots.map { outline(it.start) }
    val obstacles: List<Pair<Thing, Outline>> =
        world.walls.mapIndexed { number, wall -> Thing(ThingKind.WALL, number) to outline(wall) } +
            world.barriers.mapIndexed { number, barrier -> Thing(ThingKind.BARRIER, number) to flat(barrier.shape) } +
            world.blocks.mapIndexed { number, block -> Thing(ThingKind.BLOCK, number) to flat(block.shape) }
    return robots.flatMapIndexed { number, robot ->
        val thing = Thing(ThingKind.ROBOT, number)
        val start = world.robots[number].start
        val inTheWay = obstacles.firstOrNull { (_, obstacle) -> overlap(robot, obstacle) }?.first
            ?: (0..<number).firstOrNull { overlap(robot, robots[it]) }?.let { Thing(ThingKind.ROBOT, it) }
        listOfNotNull(
            Trouble.OffPaper(thing).takeIf { !world.paper.contains(start.x, start.y) },
            inTheWay?.let { Trouble.InTheWay(thing, it) },
        )
    }
}

private fun shapeTroubles(world: World): List<Trouble> = world.things().mapNotNull { thing ->
    val polygon = (world.piece(thing)?.form as? Form.Area)?.shape as? Shape.Polygon ?: return@mapNotNull null
    val isTangled = edgesCross(polygon.corners) || abs(signedArea(polygon.corners)) / 2 < WorldLimits.MINIMUM_AREA
    Trouble.Tangled(thing).takeIf { isTangled }
}

private fun goalTroubles(world: World): List<Trouble> {
    val robots = world.robots.map { it.name }.toSet()
    val movable = robots + world.blocks.mapNotNull { it.name }
    val lines = world.marks.filter { it.figure is MarkFigure.Line }.mapNotNull { it.name }.toSet()
    return allGoals(world.goals).mapIndexedNotNull { number, (goal, _) ->
        val thing = Thing(ThingKind.GOAL, number)
        val condition = goal.condition
        val who = goal.who
        val mayBeBlock = condition is HasActor && condition.mayBeBlock
        val line = (condition as? HasLine)?.line
        when {
            who != null && who !in (if (mayBeBlock) movable else robots) -> Trouble.NobodyThere(thing, who)
            line != null && line !in lines -> Trouble.NoSuchLine(thing, line)
            condition is NeedsTemplate && world.template == null -> Trouble.NothingToTrace(thing)
            else -> null
        }
    }
}
