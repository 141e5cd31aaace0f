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
sealed interface ValidationError {
    /** What it is about; null for the world as a whole. */
    val thing: ElementRef?

    /** A robot would start in [other]. */
    data class Obstructed(override val thing: ElementRef, val other: ElementRef) : ValidationError

    /** A robot would start beside the paper. */
    data class OffPaper(override val thing: ElementRef) : ValidationError

    /** The edges of a polygon cross or touch each other, or there is hardly anything between them. */
    data class SelfIntersecting(override val thing: ElementRef) : ValidationError

    /** A goal is about somebody who is not there. */
    data class MissingActor(override val thing: ElementRef, val name: String) : ValidationError

    /** A goal is about a line that is not there. */
    data class NoSuchLine(override val thing: ElementRef, val name: String) : ValidationError

    /** A goal is about the drawing to be traced, and there is none. */
    data class NothingToTrace(override val thing: ElementRef) : ValidationError

    /** Something that none of the others is, as the reader of world files says it. */
    data class Rejected(private val world: World) : ValidationError {
        override val thing: ElementRef? get() = null

        /** A sentence; empty if nothing is wrong with the world after all. */
        fun message(language: Language): String =
            (readWorld(writeWorld(world), language) as? WorldFileResult.Rejected)?.message.orEmpty()
    }
}

/** What is to be seen at once of what is wrong with [world]. */
fun plainTroubles(world: World): List<ValidationError> =
    startTroubles(world) + shapeTroubles(world) + goalTroubles(world)

/** All that is wrong with [world]: if this is empty, a file of it can be read again. */
fun troublesOf(world: World): List<ValidationError> = plainTroubles(world).ifEmpty {
    when (readWorld(writeWorld(world))) {
        is WorldFileResult.Loaded -> emptyList()
        is WorldFileResult.Rejected -> listOf(ValidationError.Rejected(world))
    }
}

private fun startTroubles(world: World): List<ValidationError> {
    val robots = world.robots.map { outline(it.start) }
    val obstacles: List<Pair<ElementRef, Outline>> =
        world.walls.mapIndexed { number, wall -> ElementRef(ElementKind.WALL, number) to outline(wall) } +
            world.barriers.mapIndexed { number, barrier ->
                ElementRef(ElementKind.BARRIER, number) to
                    flat(barrier.shape)
            } +
            world.blocks.mapIndexed { number, block -> ElementRef(ElementKind.BLOCK, number) to flat(block.shape) }
    return robots.flatMapIndexed { number, robot ->
        val thing = ElementRef(ElementKind.ROBOT, number)
        val start = world.robots[number].start
        val inTheWay = obstacles.firstOrNull { (_, obstacle) -> overlap(robot, obstacle) }?.first
            ?: (0..<number).firstOrNull { overlap(robot, robots[it]) }?.let { ElementRef(ElementKind.ROBOT, it) }
        listOfNotNull(
            ValidationError.OffPaper(thing).takeIf { !world.paper.contains(start.x, start.y) },
            inTheWay?.let { ValidationError.Obstructed(thing, it) },
        )
    }
}

private fun shapeTroubles(world: World): List<ValidationError> = world.things().mapNotNull { thing ->
    val polygon = (world.piece(thing)?.form as? Form.Area)?.shape as? Shape.Polygon ?: return@mapNotNull null
    val isTangled = edgesCross(polygon.corners) || abs(signedArea(polygon.corners)) / 2 < WorldLimits.MINIMUM_AREA
    ValidationError.SelfIntersecting(thing).takeIf { isTangled }
}

private fun goalTroubles(world: World): List<ValidationError> {
    val robots = world.robots.map { it.name }.toSet()
    val movable = robots + world.blocks.mapNotNull { it.name }
    val lines = world.marks.filter { it.figure is MarkFigure.Line }.mapNotNull { it.name }.toSet()
    return allGoals(world.goals).mapIndexedNotNull { number, (goal, _) ->
        val thing = ElementRef(ElementKind.GOAL, number)
        val condition = goal.condition
        val who = goal.who
        val mayBeBlock = condition is HasActor && condition.mayBeBlock
        val line = (condition as? HasLine)?.line
        when {
            who != null && who !in (if (mayBeBlock) movable else robots) -> ValidationError.MissingActor(thing, who)
            line != null && line !in lines -> ValidationError.NoSuchLine(thing, line)
            condition is NeedsTemplate && world.template == null -> ValidationError.NothingToTrace(thing)
            else -> null
        }
    }
}
