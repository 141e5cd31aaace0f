package robotran.narration

import robotran.language.Language
import robotran.simulation.messages.GoalMessages
import robotran.simulation.messages.wordFor
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState
import robotran.world.Goal
import robotran.world.HasLine
import robotran.world.HasRegion
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.NeedsTemplate
import robotran.world.RegionRole
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.centre
import robotran.world.geometry.flat

/** Each goal with its progress, and where its place is as the robot sees it; a place is told once. */
internal fun RobotScene.goals(language: Language): List<String> {
    val words = GoalMessages.of(language)
    val told = leaves(world.goals, session.goals)
    val places = mutableSetOf<String>()
    return buildList {
        told.take(MAX_GOALS).forEachIndexed { index, (goal, progress) ->
            val place = if (progress.status == GoalStatus.MET) emptyList() else placeOf(goal).filter(places::add)
            val sentence = messages.goal(numberOf(index, told), words.wordFor(progress.status), progress.sentence)
            add((listOf(sentence) + place).joinToString(" "))
        }
        if (told.size > MAX_GOALS) add(messages.moreGoals(told.size - MAX_GOALS))
    }
}

/**
 * The place of a goal that is not reached yet, for whoever is at a spot of the sheet.
 *
 * @property number null if there is only one goal.
 */
internal class WantedPlace(val number: Int?, val point: Point)

/** The place of the first goal that is still to be reached, for whoever is at [from]; null if there is none. */
internal fun wantedFrom(from: Point, world: World, session: SessionState): WantedPlace? {
    val goals = leaves(world.goals, session.goals)
    return goals.withIndex().firstNotNullOfOrNull { (index, leaf) ->
        val (goal, progress) = leaf
        if (progress.status == GoalStatus.MET) return@firstNotNullOfOrNull null
        wantedPoint(goal, from, world)?.let { WantedPlace(numberOf(index, goals), it) }
    }
}

private fun numberOf(index: Int, goals: List<*>): Int? = (index + 1).takeIf { goals.size > 1 }

private fun wantedPoint(goal: Goal, from: Point, world: World): Point? = when (val condition = goal.condition) {
    is HasRegion -> {
        val isIn = flat(condition.region).contains(from.x, from.y)
        when (condition.role) {
            RegionRole.TARGET -> if (isIn) from else condition.region.centre
            RegionRole.PERMITTED -> if (isIn) null else flat(condition.region).nearestEdgePoint(from)
            RegionRole.FORBIDDEN -> null
        }
    }

    is HasLine -> lineOf(condition, world)?.second?.let { nearestOf(it, from) }
    is NeedsTemplate -> onDrawing(world, from)
    else -> null
}

/** The point of the drawing to trace that is nearest to [point]. */
private fun onDrawing(world: World, point: Point): Point? =
    world.template?.strokes.orEmpty().map { nearestOf(it, point) }.minByOrNull { apart(it, point) }

/** The goals that are no groups, with their progress. */
private fun leaves(goals: List<Goal>, progress: List<GoalProgress>): List<Pair<Goal, GoalProgress>> =
    goals.zip(progress).flatMap { (goal, now) ->
        if (goal.isGroup && now.parts.isNotEmpty()) leaves(goal.parts, now.parts) else listOf(goal to now)
    }

private fun RobotScene.placeOf(goal: Goal): List<String> = when (val condition = goal.condition) {
    is HasRegion -> regionOf(condition)

    is HasLine -> {
        lineOf(condition, world)?.let { (mark, way) -> listOf(nearest(groundOf(mark), nearestOf(way, pose.point))) }
    }

    is NeedsTemplate -> {
        drawing() ?: onDrawing(world, pose.point)?.let { listOf(nearest(Ground(GroundKind.TEMPLATE), it)) }
    }

    else -> null
}.orEmpty()

private fun RobotScene.regionOf(condition: HasRegion): List<String> {
    val outline = flat(condition.region)
    val isIn = outline.contains(pose.x, pose.y)
    return when (condition.role) {
        RegionRole.TARGET -> {
            val middle = condition.region.centre
            val away = messages.goalAway(centimetres(pose.distanceTo(middle)), turnTo(middle))
            listOfNotNull(away, inTheWayTo(middle))
        }

        RegionRole.FORBIDDEN -> {
            if (isIn) {
                emptyList()
            } else {
                listOf(
                    nearest(Ground(GroundKind.FORBIDDEN), outline.nearestEdgePoint(pose.point)),
                )
            }
        }

        RegionRole.PERMITTED -> {
            if (isIn) {
                emptyList()
            } else {
                listOf(
                    nearest(Ground(GroundKind.PERMITTED), outline.nearestEdgePoint(pose.point)),
                )
            }
        }
    }
}

private fun lineOf(condition: HasLine, world: World): Pair<Mark, List<Point>>? {
    val mark = world.marks.find { it.name == condition.line } ?: return null
    return (mark.figure as? MarkFigure.Line)?.let { mark to it.way }
}

private fun RobotScene.nearest(ground: Ground, point: Point): String {
    val words = messages.ground(ground.kind, ground.name, ground.tone)
    return messages.nearestAway(words, centimetres(pose.distanceTo(point)), turnTo(point))
}

private const val MAX_GOALS = 6
