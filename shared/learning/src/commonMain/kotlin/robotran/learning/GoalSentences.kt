package robotran.learning

import robotran.world.World

/** The sentences below the heading `Goals` of a text, one for each line that begins with a dash. */
internal fun goalSentences(body: String): List<String> =
    body.lines().filter { it.startsWith(DASH) }.map { it.removePrefix(DASH).trim() }

/** The same world, whose goals say what is in [translated] at the place that their own sentence has in [written]. */
internal fun World.withGoalsSaid(written: List<String>, translated: List<String>): World {
    val sentences = written.zip(translated).toMap()
    return copy(goals = goals.map { goal -> goal.withSays { sentences[it] ?: it } })
}

private const val DASH = "- "
