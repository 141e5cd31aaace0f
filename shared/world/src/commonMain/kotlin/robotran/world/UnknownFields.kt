package robotran.world

import kotlinx.serialization.json.JsonElement

/** Fields of a file that this version knows nothing of: kept when it is loaded, written again when it is saved. */
class UnknownFields internal constructor(internal val members: Map<String, JsonElement>) {
    override fun equals(other: Any?): Boolean = other is UnknownFields && other.members == members

    override fun hashCode(): Int = members.hashCode()

    override fun toString(): String = members.toString()

    companion object {
        val NONE = UnknownFields(emptyMap())
    }
}
