package robotran.json

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** An object with the members that [build] puts in, in that order, and what [JsonCursor.rest] has kept of it. */
fun jsonObject(rest: Map<String, JsonElement> = emptyMap(), build: ObjectBuilder.() -> Unit): JsonObject =
    JsonObject(ObjectBuilder().apply(build).members).withRest(rest)

/** Puts members into an object; null, and what is as usual anyway, is left out. */
class ObjectBuilder internal constructor() {
    internal val members = linkedMapOf<String, JsonElement>()

    fun text(name: String, value: String?, usual: String? = null) {
        if (value != null && value != usual) members[name] = JsonPrimitive(value)
    }

    fun number(name: String, value: Double, usual: Double? = null) {
        if (value != usual) members[name] = decimal(value)
    }

    fun number(name: String, value: Long?, usual: Long? = null) {
        if (value != null && value != usual) members[name] = JsonPrimitive(value)
    }

    fun number(name: String, value: Int?, usual: Int? = null) = number(name, value?.toLong(), usual?.toLong())

    fun flag(name: String, value: Boolean, usual: Boolean?) {
        if (value != usual) members[name] = JsonPrimitive(value)
    }

    fun put(name: String, value: JsonElement?) {
        if (value != null) members[name] = value
    }

    /** An empty list is left out. */
    fun <T> list(name: String, items: List<T>, write: (T) -> JsonElement) {
        if (items.isNotEmpty()) members[name] = JsonArray(items.map(write))
    }
}
