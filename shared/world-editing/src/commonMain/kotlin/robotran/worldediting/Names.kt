package robotran.worldediting

import robotran.editing.isValidText
import robotran.world.HasLine
import robotran.world.World
import robotran.world.WorldLimits

/** The named elements with their names. */
internal fun World.names(): Map<ElementRef, String> = buildMap {
    for (thing in things()) piece(thing)?.name?.let { put(thing, it) }
}

/** [wanted], with a number appended if the name is taken. */
fun World.uniqueName(wanted: String): String = uniqueName(wanted, names().values.toSet())

internal fun uniqueName(wanted: String, taken: Set<String>): String {
    if (wanted !in taken) return wanted
    val stem = wanted.replace(Regex(" \\d+$"), "")
    return generateSequence(2) { it + 1 }
        .map { number -> stem.take(WorldLimits.MAXIMUM_NAME_CHARACTERS - " $number".length).trimEnd() + " $number" }
        .first { it !in taken && isValidText(it, WorldLimits.MAXIMUM_NAME_CHARACTERS) }
}

/** Replaces the name [before] by [after] in the goals that refer to it. */
internal fun World.withGoalsRenamed(before: String, after: String): World = copy(
    goals = goals.changed { _, goal ->
        val renamed = if (goal.who == before) goal.withWho(after) else goal
        val condition = renamed.condition
        if (condition is HasLine && condition.line == before) {
            renamed.copy(condition = condition.withLine(after))
        } else {
            renamed
        }
    },
)
