package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.ObjectBuilder
import robotran.json.decimal
import robotran.json.jsonObject
import robotran.world.Goal
import robotran.world.TouchKind
import robotran.world.geometry.Shape

internal fun elementOf(goal: Goal): JsonObject = jsonObject(goal.unknown.members) {
    when (goal) {
        is Goal.Reach -> {
            place("reach", goal.region, goal.who, goal.whole)
            number("within", goal.within)
            flag("stays", goal.stays, usual = false)
        }

        is Goal.StayOut -> {
            place("stayOut", goal.region, goal.who, goal.whole)
        }

        is Goal.StayIn -> {
            place("stayIn", goal.region, goal.who, goal.whole)
        }

        is Goal.NeverTouch -> {
            text("kind", "neverTouch")
            val words = TouchKind.entries.filter { it in goal.what }.map { JsonPrimitive(wordFor(it)) }
            if (words.size < TouchKind.entries.size) put("what", JsonArray(words))
            text("who", goal.who)
        }

        is Goal.DrawTemplate -> {
            text("kind", "drawTemplate")
            number("tolerance", goal.tolerance, GoalReader.USUAL_DRAWING.tolerance)
            number("coverage", goal.coverage, GoalReader.USUAL_DRAWING.coverage)
            number("excess", goal.excess, GoalReader.USUAL_DRAWING.excess)
        }

        is Goal.InkLength -> {
            text("kind", "inkLength")
            put("atLeast", goal.atLeast?.let(::decimal))
            put("atMost", goal.atMost?.let(::decimal))
        }

        is Goal.FollowLine -> {
            text("kind", "followLine")
            text("line", goal.line)
            number("laps", goal.laps, GoalReader.USUAL_FOLLOWING.laps)
            number("tolerance", goal.tolerance, GoalReader.USUAL_FOLLOWING.tolerance)
            text("who", goal.who)
            number("within", goal.within)
        }

        is Goal.EndWithin -> {
            text("kind", "endWithin")
            number("seconds", goal.seconds)
            text("who", goal.who)
        }

        is Goal.ShowOnDisplay -> {
            text("kind", "showOnDisplay")
            text("text", goal.text)
            text("who", goal.who)
        }

        is Goal.PlaySound -> {
            text("kind", "playSound")
            number("times", goal.times, usual = 1)
            number("lowest", goal.lowest)
            number("highest", goal.highest)
            text("who", goal.who)
        }

        is Goal.InOrder -> {
            group("inOrder", goal.goals)
        }

        is Goal.All -> {
            group("all", goal.goals)
        }

        is Goal.AnyOf -> {
            group("anyOf", goal.goals)
        }
    }
    text("says", goal.says)
}

private fun ObjectBuilder.place(kind: String, region: Shape, who: String?, whole: Boolean) {
    text("kind", kind)
    put("region", jsonObject { shape(region) })
    text("who", who)
    flag("whole", whole, usual = false)
}

private fun ObjectBuilder.group(kind: String, goals: List<Goal>) {
    text("kind", kind)
    list("goals", goals, ::elementOf)
}
