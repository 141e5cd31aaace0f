package robotran.world

import kotlinx.serialization.json.JsonElement

/**
 * Fields of a file that this version knows nothing of: kept when it is loaded, written again when it is saved.
 *
 * @property members by their names; under the name of a known field that is an object itself, what that has beyond the
 * known.
 */
class UnknownFields(val members: Map<String, JsonElement>) {
    override fun equals(other: Any?): Boolean = other is UnknownFields && other.members == members

    override fun hashCode(): Int = members.hashCode()

    override fun toString(): String = members.toString()

    companion object {
        val NONE = UnknownFields(emptyMap())
    }
}
