package robotran.world.file

import robotran.json.JsonPlace
import robotran.world.Goal
import robotran.world.MarkFigure
import robotran.world.World

/** Refuses a name that two things have, and goals that name what is not there. */
internal fun checkNames(world: World, file: JsonPlace) {
    val owners = mutableMapOf<String, JsonPlace>()
    for ((list, names) in namesIn(world)) {
        val places = file.optional(list)?.items(0..Int.MAX_VALUE) ?: continue
        names.forEachIndexed { number, name ->
            if (name == null) return@forEachIndexed
            owners[name]?.let { places[number].refuse(told { nameTaken(name, it.path.toString()) }) }
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

    fun check(goals: List<Goal>, place: JsonPlace) {
        val places = place.items(0..Int.MAX_VALUE)
        goals.forEachIndexed { number, goal -> check(goal, places[number]) }
    }

    private fun check(goal: Goal, place: JsonPlace) {
        when (goal) {
            is Goal.Reach -> {
                known(goal.who, movable, place)
            }

            is Goal.StayOut -> {
                known(goal.who, movable, place)
            }

            is Goal.StayIn -> {
                known(goal.who, movable, place)
            }

            is Goal.NeverTouch -> {
                known(goal.who, robots, place)
            }

            is Goal.FollowLine -> {
                known(goal.who, robots, place)
                if (goal.line !in lines) place.member("line").refuse(told { mustNameLine() })
            }

            is Goal.EndWithin -> {
                known(goal.who, robots, place)
            }

            is Goal.ShowOnDisplay -> {
                known(goal.who, robots, place)
            }

            is Goal.PlaySound -> {
                known(goal.who, robots, place)
            }

            is Goal.DrawTemplate -> {
                if (world.template == null) place.refuse(told { needsTemplate() })
            }

            is Goal.InkLength -> {}

            is Goal.InOrder -> {
                check(goal.goals, place.member("goals"))
            }

            is Goal.All -> {
                check(goal.goals, place.member("goals"))
            }

            is Goal.AnyOf -> {
                check(goal.goals, place.member("goals"))
            }
        }
    }

    private fun known(who: String?, names: List<String>, place: JsonPlace) {
        if (who == null || who in names) return
        place.member("who").refuse(told { if (names === movable) mustNameRobotOrBlock() else mustNameRobot() })
    }
}
