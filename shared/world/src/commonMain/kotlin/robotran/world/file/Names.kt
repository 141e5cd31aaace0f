package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.Goal
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.HasParts
import robotran.world.MarkFigure
import robotran.world.NeedsTemplate
import robotran.world.World
import robotran.world.messages.reason

/** Rejects duplicate names, and goals that refer to missing robots or objects. */
internal fun checkNames(world: World, file: JsonCursor) {
    val owners = mutableMapOf<String, JsonCursor>()
    for ((list, names) in namesIn(world)) {
        val places = file.optional(list)?.items(0..Int.MAX_VALUE) ?: continue
        names.forEachIndexed { number, name ->
            if (name == null) return@forEachIndexed
            owners[name]?.let { places[number].refuse(reason { nameTaken(name, it.path.toString()) }) }
            owners[name] = places[number]
        }
    }
    file.optional("goals")?.let { GoalNames(world).check(world.goals, it) }
}

private fun namesIn(world: World): Map<String, List<String?>> = mapOf(
    "robots" to world.robots.map { it.name },
    "barriers" to world.barriers.map { it.name },
    "blocks" to world.blocks.map { it.name },
    "marks" to world.marks.map { it.name },
    "lamps" to world.lamps.map { it.name },
)

private class GoalNames(private val world: World) {
    private val robots = world.robots.map { it.name }
    private val movable = robots + world.blocks.mapNotNull { it.name }
    private val lines = world.marks.filter { it.figure is MarkFigure.Line }.mapNotNull { it.name }

    fun check(goals: List<Goal>, cursor: JsonCursor) {
        val places = cursor.items(0..Int.MAX_VALUE)
        goals.forEachIndexed { number, goal -> check(goal, places[number]) }
    }

    private fun check(goal: Goal, cursor: JsonCursor) {
        val condition = goal.condition
        if (condition is HasActor) checkActor(condition, cursor)
        if (condition is HasLine && condition.line !in lines) cursor.member("line").refuse(reason { mustNameLine() })
        if (condition is NeedsTemplate && world.template == null) cursor.refuse(reason { needsTemplate() })
        if (condition is HasParts) check(condition.goals, cursor.member("goals"))
    }

    private fun checkActor(condition: HasActor, cursor: JsonCursor) {
        val who = condition.who ?: return
        if (who in (if (condition.mayBeBlock) movable else robots)) return
        cursor.member("who").refuse(reason { if (condition.mayBeBlock) mustNameRobotOrBlock() else mustNameRobot() })
    }
}
