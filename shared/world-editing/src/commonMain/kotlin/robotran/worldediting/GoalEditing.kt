package robotran.worldediting

import robotran.world.Goal
import robotran.world.HasLine
import robotran.world.MarkFigure
import robotran.world.NeedsTemplate

/** A copy of the goal that is a different object. */
internal fun Goal.separate(): Goal = withParts(parts.map { it.separate() }).tidied()

internal fun WorldEditing.goalAdded(edit: WorldEdit.AddGoal): Outcome? {
    val goal = edit.goal.separate()
    val all = listOf(goal) + allGoals(goal.parts).map { it.goal }
    if (goal.isGroup && goal.parts.isEmpty()) return null
    if (all.any { it.condition is HasLine } && world.marks.none { it.figure is MarkFigure.Line }) {
        return Outcome.Not(WorldEditError.NeedsLine)
    }
    if (all.any { it.condition is NeedsTemplate } &&
        world.template == null
    ) {
        return Outcome.Not(WorldEditError.NeedsTemplate)
    }
    all.firstNotNullOfOrNull { errorOf(it) }?.let { return Outcome.Not(it) }
    val into = edit.into?.takeIf { allGoals(world.goals).getOrNull(it)?.goal?.isGroup == true }
    val goals = if (into == null) {
        world.goals + goal
    } else {
        world.goals.replaced(into) { listOf(it.withParts(it.parts + goal)) }
    }
    val changed = world.copy(goals = goals)
    val number = allGoals(goals).indexOfFirst { it.goal === goal }
    return Outcome.Made(
        WorldSnapshot(
            changed,
            setOf(ElementRef(ElementKind.GOAL, number)),
            groups.map {
                renumbered(it, world, changed)
            },
        ),
    )
}

/** The world with [goals]; keeps the selection. */
internal fun WorldEditing.goals(goals: List<Goal>?): Outcome? {
    if (goals == null) return null
    val changed = world.copy(goals = goals)
    return Outcome.Made(
        WorldSnapshot(
            changed,
            renumbered(selection, world, changed),
            groups.map {
                renumbered(it, world, changed)
            },
        ),
    )
}

internal fun List<Goal>.wrapped(number: Int, group: GoalGroup): List<Goal>? {
    if (number !in allGoals(this).indices) return null
    return replaced(number) { listOf(Goal(group.around(it))) }
}

internal fun List<Goal>.unwrapped(number: Int): List<Goal>? =
    if (allGoals(this).getOrNull(number)?.goal?.isGroup == true) replaced(number) { it.parts } else null

/** [goals] with the goal at index [number] moved; null if it cannot move there. */
internal fun movedGoal(goals: List<Goal>, number: Int, move: GoalMove): List<Goal>? {
    val goal = allGoals(goals).getOrNull(number)?.goal ?: return null
    return movedWithin(goals, goal, move)
}

private fun movedWithin(goals: List<Goal>, goal: Goal, move: GoalMove): List<Goal>? {
    val place = goals.indexOfFirst { it === goal }
    if (place >= 0) return movedHere(goals, place, move)
    for ((outer, group) in goals.withIndex()) {
        val inner = group.parts.indexOfFirst { it === goal }
        if (inner >= 0 && move == GoalMove.OUT) {
            val left = group.parts.filterIndexed { number, _ -> number != inner }
            val stays = if (left.isEmpty()) emptyList() else listOf(group.withParts(left))
            return goals.take(outer) + stays + goal + goals.drop(outer + 1)
        }
        if (group.isGroup) movedWithin(group.parts, goal, move)?.let { return goals.with(outer, group.withParts(it)) }
    }
    return null
}

private fun movedHere(goals: List<Goal>, index: Int, move: GoalMove): List<Goal>? {
    val goal = goals[index]
    val others = goals.filterIndexed { number, _ -> number != index }
    return when (move) {
        GoalMove.UP -> if (index == 0) null else others.take(index - 1) + goal + others.drop(index - 1)
        GoalMove.DOWN -> if (index == goals.lastIndex) null else others.take(index + 1) + goal + others.drop(index + 1)

        GoalMove.IN -> others.getOrNull(index - 1)?.takeIf {
            it.isGroup
        }?.let { others.with(index - 1, it.withParts(it.parts + goal)) }

        GoalMove.OUT -> null
    }
}

/** The list with the goal at index [number] replaced. */
private fun List<Goal>.replaced(number: Int, change: (Goal) -> List<Goal>): List<Goal> {
    val wanted = allGoals(this)[number].goal
    return flatMap { goal ->
        when {
            goal === wanted -> change(goal)

            goal.isGroup && allGoals(goal.parts).any { it.goal === wanted } -> {
                listOf(goal.withParts(goal.parts.replacedOne(wanted, change)))
            }

            else -> listOf(goal)
        }
    }
}

private fun List<Goal>.replacedOne(wanted: Goal, change: (Goal) -> List<Goal>): List<Goal> {
    val number = allGoals(this).indexOfFirst { it.goal === wanted }
    return replaced(number, change)
}
