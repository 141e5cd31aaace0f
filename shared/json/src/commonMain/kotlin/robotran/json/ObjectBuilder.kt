package robotran.json

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** An object with the members from [build], in that order, and the unread members from [JsonCursor.rest]. */
fun jsonObject(rest: Map<String, JsonElement> = emptyMap(), build: ObjectBuilder.() -> Unit): JsonObject =
    JsonObject(ObjectBuilder().apply(build).members).withRest(rest)

/** Adds members to an object; omits null and default values. */
class ObjectBuilder internal constructor() {
    internal val members = linkedMapOf<String, JsonElement>()

    fun text(name: String, value: String?, default: String? = null) {
        if (value != null && value != default) members[name] = JsonPrimitive(value)
    }

    fun number(name: String, value: Double, default: Double? = null) {
        if (value != default) members[name] = decimal(value)
    }

    fun number(name: String, value: Long?, default: Long? = null) {
        if (value != null && value != default) members[name] = JsonPrimitive(value)
    }

    fun number(name: String, value: Int?, default: Int? = null) = number(name, value?.toLong(), default?.toLong())

    fun flag(name: String, value: Boolean, default: Boolean?) {
        if (value != default) members[name] = JsonPrimitive(value)
    }

    fun put(name: String, value: JsonElement?) {
        if (value != null) members[name] = value
    }

    /** Omits an empty list. */
    fun <T> list(name: String, items: List<T>, write: (T) -> JsonElement) {
        if (items.isNotEmpty()) members[name] = JsonArray(items.map(write))
    }
}
