package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.ObjectBuilder
import robotran.json.jsonObject
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasRegion
import robotran.world.TouchKind

/**
 * Reads and writes one kind of condition in a world file.
 *
 * @property kind its keyword in the file.
 * @property read creates the condition from its fields; the fields that all goals share are read elsewhere.
 * @param writer writes a condition's fields; null for a condition of another kind.
 */
internal class GoalCodec(
    val kind: String,
    val read: GoalConditionFields.() -> GoalCondition,
    private val writer: (GoalCondition) -> (ObjectBuilder.() -> Unit)?,
) {
    /** Writes [condition] into [fields] if it is of this kind. Returns whether it is. */
    fun write(condition: GoalCondition, fields: ObjectBuilder): Boolean {
        val write = writer(condition) ?: return false
        fields.text("kind", kind)
        fields.write()
        return true
    }
}

/** A codec for conditions of the type [C]. */
internal inline fun <reified C : GoalCondition> codec(
    kind: String,
    noinline read: GoalConditionFields.() -> C,
    noinline write: ObjectBuilder.(C) -> Unit,
) = GoalCodec(kind, read) { condition -> if (condition is C) ({ write(condition) }) else null }

internal fun elementOf(goal: Goal): JsonObject = jsonObject(goal.unknown.members) {
    check(GOAL_CODECS.any { it.write(goal.condition, this) }) { "No codec writes ${goal.condition}" }
    text("says", goal.says)
}

internal fun ObjectBuilder.actorInRegion(condition: HasRegion) {
    put("region", jsonObject { shape(condition.region) })
    text("who", condition.who)
    flag("whole", condition.whole, default = false)
}

internal fun ObjectBuilder.touchKinds(what: Set<TouchKind>) {
    val words = TouchKind.entries.filter { it in what }.map { JsonPrimitive(wordFor(it)) }
    if (words.size < TouchKind.entries.size) put("what", JsonArray(words))
}

internal fun ObjectBuilder.parts(goals: List<Goal>) = list("goals", goals, ::elementOf)
