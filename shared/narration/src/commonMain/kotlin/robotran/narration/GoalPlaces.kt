package robotran.narration

import robotran.language.Language
import robotran.simulation.messages.GoalMessages
import robotran.simulation.messages.wordFor
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.HasLine
import robotran.world.HasRegion
import robotran.world.MarkFigure
import robotran.world.NeedsTemplate
import robotran.world.RegionRole
import robotran.world.geometry.Point
import robotran.world.geometry.centre
import robotran.world.geometry.flat

/** Each goal with its progress, and where its place is as the robot sees it. */
internal fun RobotScene.goals(language: Language): List<String> {
    val words = GoalMessages.of(language)
    val told = leaves(world.goals, session.goals)
    val several = told.size > 1
    return buildList {
        told.take(MOST_GOALS).forEachIndexed { index, (goal, progress) ->
            val number = (index + 1).takeIf { several }
            val place = if (progress.status == GoalStatus.MET) null else placeOf(goal)
            val sentence = messages.goal(number, words.wordFor(progress.status), progress.sentence)
            add(listOfNotNull(sentence, place).joinToString(" "))
        }
        if (told.size > MOST_GOALS) add(messages.moreGoals(told.size - MOST_GOALS))
    }
}

/** The goals that are no groups, with their progress. */
private fun leaves(goals: List<Goal>, progress: List<GoalProgress>): List<Pair<Goal, GoalProgress>> =
    goals.zip(progress).flatMap { (goal, now) ->
        if (goal.isGroup && now.parts.isNotEmpty()) leaves(goal.parts, now.parts) else listOf(goal to now)
    }

private fun RobotScene.placeOf(goal: Goal): String? = when (val condition = goal.condition) {
    is HasRegion -> regionOf(condition)
    is HasLine -> lineOf(condition)

    is NeedsTemplate -> {
        val points = world.template?.strokes.orEmpty().map { nearestOf(it, pose.point) }
        points.minByOrNull { apart(it, pose.point) }?.let { nearest(Ground(GroundKind.TEMPLATE), it) }
    }

    else -> null
}

private fun RobotScene.regionOf(condition: HasRegion): String? {
    val outline = flat(condition.region)
    val isIn = outline.contains(pose.x, pose.y)
    return when (condition.role) {
        RegionRole.TARGET -> {
            val middle = condition.region.centre
            messages.goalAway(centimetres(pose.distanceTo(middle)), turnTo(middle))
        }

        RegionRole.FORBIDDEN -> {
            if (isIn) null else nearest(Ground(GroundKind.FORBIDDEN), outline.nearestEdgePoint(pose.point))
        }

        RegionRole.PERMITTED -> {
            if (isIn) null else nearest(Ground(GroundKind.PERMITTED), outline.nearestEdgePoint(pose.point))
        }
    }
}

private fun RobotScene.lineOf(condition: HasLine): String? {
    val mark = world.marks.find { it.name == condition.line } ?: return null
    val line = mark.figure as? MarkFigure.Line ?: return null
    return nearest(groundOf(mark), nearestOf(line.way, pose.point))
}

private fun RobotScene.nearest(ground: Ground, point: Point): String {
    val words = messages.ground(ground.kind, ground.name, ground.tone)
    return messages.nearestAway(words, centimetres(pose.distanceTo(point)), turnTo(point))
}

private const val MOST_GOALS = 6
