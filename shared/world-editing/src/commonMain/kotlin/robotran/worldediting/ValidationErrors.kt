package robotran.worldediting

import robotran.language.Language
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.MarkFigure
import robotran.world.NeedsTemplate
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.file.WorldFileResult
import robotran.world.file.outline
import robotran.world.file.readWorld
import robotran.world.file.writeWorld
import robotran.world.geometry.Outline
import robotran.world.geometry.Shape
import robotran.world.geometry.edgesCross
import robotran.world.geometry.flat
import robotran.world.geometry.overlap
import robotran.world.geometry.signedArea
import kotlin.math.abs

/** An error that must be fixed before a world can be saved or run. */
sealed interface ValidationError {
    /** The element with the error; null for the whole world. */
    val thing: ElementRef?

    /** A robot would start in [other]. */
    data class Obstructed(override val thing: ElementRef, val other: ElementRef) : ValidationError

    /** A robot would start beside the paper. */
    data class OffPaper(override val thing: ElementRef) : ValidationError

    /** The edges of a polygon cross or touch each other, or its area is almost zero. */
    data class SelfIntersecting(override val thing: ElementRef) : ValidationError

    /** A goal refers to a missing robot or block. */
    data class MissingActor(override val thing: ElementRef, val name: String) : ValidationError

    /** A goal refers to a missing line. */
    data class MissingLine(override val thing: ElementRef, val name: String) : ValidationError

    /** A goal refers to the template, and there is none. */
    data class MissingTemplate(override val thing: ElementRef) : ValidationError

    /** Any other error, with the message of the world file reader. */
    data class Rejected(private val world: World) : ValidationError {
        override val thing: ElementRef? get() = null

        /** A sentence; empty if the world is valid. */
        fun message(language: Language): String =
            (readWorld(writeWorld(world), language) as? WorldFileResult.Failure)?.message.orEmpty()
    }
}

/** The errors of [world] that can be found quickly. */
fun quickValidationErrorsOf(world: World): List<ValidationError> =
    startErrors(world) + shapeErrors(world) + goalErrors(world)

/** All errors of [world]; if empty, its file can be read again. */
fun validationErrorsOf(world: World): List<ValidationError> = quickValidationErrorsOf(world).ifEmpty {
    when (readWorld(writeWorld(world), Language.ENGLISH)) {
        is WorldFileResult.Success -> emptyList()
        is WorldFileResult.Failure -> listOf(ValidationError.Rejected(world))
    }
}

private fun startErrors(world: World): List<ValidationError> {
    val robots = world.robots.map { outline(it.start, it.description) }
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

private fun shapeErrors(world: World): List<ValidationError> = world.things().mapNotNull { thing ->
    val polygon = (world.piece(thing)?.form as? Form.Area)?.shape as? Shape.Polygon ?: return@mapNotNull null
    val isTangled = edgesCross(polygon.corners) || abs(signedArea(polygon.corners)) / 2 < WorldLimits.MINIMUM_AREA
    ValidationError.SelfIntersecting(thing).takeIf { isTangled }
}

private fun goalErrors(world: World): List<ValidationError> {
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
            line != null && line !in lines -> ValidationError.MissingLine(thing, line)
            condition is NeedsTemplate && world.template == null -> ValidationError.MissingTemplate(thing)
            else -> null
        }
    }
}
