package robotran.world

import kotlinx.serialization.json.JsonElement

/**
 * Fields of a file that this version does not know; preserved from loading to saving.
 *
 * @property members by name; under the name of a known field that is an object, its unknown members.
 */
class UnknownFields(val members: Map<String, JsonElement>) {
    override fun equals(other: Any?): Boolean = other is UnknownFields && other.members == members

    override fun hashCode(): Int = members.hashCode()

    override fun toString(): String = members.toString()

    companion object {
        val NONE = UnknownFields(emptyMap())
    }
}
