package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.Goal
import robotran.world.TouchKind
import robotran.world.WorldLimits
import robotran.world.geometry.Shape
import robotran.world.messages.reason

/** Reads goals, and counts them. */
internal class GoalReader(private val shapes: ShapeReader) {
    private var goals = 0

    fun read(cursor: JsonCursor): List<Goal> = goals(cursor, depth = 1, min = 0)

    private fun goals(cursor: JsonCursor, depth: Int, min: Int): List<Goal> {
        val deepest = WorldLimits.MAXIMUM_GOAL_DEPTH
        if (depth > deepest) cursor.refuse(reason { goalsTooDeep(deepest) })
        return cursor.items(min..WorldLimits.MAXIMUM_GOALS).map { goal(it, depth) }
    }

    private fun goal(cursor: JsonCursor, depth: Int): Goal {
        if (++goals > WorldLimits.MAXIMUM_GOALS) cursor.refuse(reason { tooManyGoals(WorldLimits.MAXIMUM_GOALS) })
        val says = cursor.optional("says")?.text(WorldLimits.MAXIMUM_SENTENCE_CHARACTERS)
        val codec = cursor.member("kind").choice(CODECS)
        val parts = { goals(cursor.member("goals"), depth + 1, min = 1) }
        return Goal(codec.read(GoalConditionFields(cursor, shapes, parts)), says, unknownOf(cursor))
    }

    private companion object {
        val CODECS = GOAL_CODECS.associateBy { it.kind }
    }
}

/**
 * The fields of a condition in a file, for the codecs of several kinds.
 *
 * @param parts reads the subgoals.
 */
internal class GoalConditionFields(
    val place: JsonCursor,
    private val shapes: ShapeReader,
    private val parts: () -> List<Goal>,
) {
    fun region(): Shape = shapes.shape(place.member("region"))

    fun who(): String? = place.optional("who")?.text(WorldLimits.MAXIMUM_NAME_CHARACTERS)

    fun flag(name: String): Boolean = place.optional(name)?.flag() ?: false

    fun within(): Int? = place.optional("within")?.wholeNumber(WorldLimits.SECONDS)

    fun tolerance(default: Double): Double =
        place.optional("tolerance")?.number(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE) ?: default

    fun text(name: String, maximum: Int): String = place.member(name).text(maximum)

    fun number(name: String, range: ClosedRange<Double>): Double? = place.optional(name)?.number(range)

    fun wholeNumber(name: String, range: IntRange): Int? = place.optional(name)?.wholeNumber(range)

    fun touchKinds(): Set<TouchKind> {
        val what = place.optional("what") ?: return TouchKind.entries.toSet()
        val kinds = what.items(1..TouchKind.entries.size).map { it.choice(TOUCH_KINDS) }
        if (kinds.toSet().size < kinds.size) what.refuse(reason { wordTwice() })
        return kinds.toSet()
    }

    fun goals(): List<Goal> = parts()

    /** Rejects a lower bound above the upper one, if both are present. */
    fun <T : Comparable<T>> checkBounds(lower: Pair<String, T?>, upper: Pair<String, T?>) {
        val (lowerName, lowest) = lower
        val (upperName, highest) = upper
        if (lowest != null && highest != null && lowest > highest) {
            place.refuse(reason { mustNotBeAbove(lowerName, upperName) })
        }
    }
}
