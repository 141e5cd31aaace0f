package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** Values that are mostly wrong instead of [value]; null removes the value. */
internal fun wrongValues(value: JsonElement): List<JsonElement?> = listOf(
    null,
    JsonNull,
    JsonPrimitive(true),
    JsonPrimitive(""),
    JsonPrimitive(" "),
    JsonPrimitive("x"),
    JsonPrimitive("#12345g"),
    JsonPrimitive(-1),
    JsonPrimitive(0),
    JsonPrimitive(0.05),
    JsonPrimitive(1.5),
    JsonPrimitive(19),
    JsonPrimitive(1e9),
    JsonPrimitive(-1e9),
    JsonPrimitive(3),
    JsonPrimitive("e".repeat(501)),
    JsonArray(emptyList()),
    JsonObject(emptyMap()),
    JsonArray(listOf(value)),
    JsonArray(listOf(value, value)),
    (value as? JsonArray)?.firstOrNull()?.let { first -> JsonArray(List(1001) { first }) } ?: JsonNull,
    (value as? JsonArray)?.let { JsonArray(it.dropLast(1)) } ?: JsonNull,
    (value as? JsonPrimitive)?.let { JsonPrimitive(it.content) } ?: JsonNull,
)

/** Copies of [element] with each of its values replaced by each of [others]. Unknown fields begin with an underscore. */
internal fun changes(element: JsonElement, others: (JsonElement) -> List<JsonElement?>): List<JsonElement> =
    when (element) {
        is JsonObject -> element.filterKeys { !it.startsWith("_") }.flatMap { (name, value) ->
            val replaced = others(value).map { other ->
                JsonObject(if (other == null) element - name else element + (name to other))
            }
            replaced + changes(value, others).map { JsonObject(element + (name to it)) }
        }

        is JsonArray -> element.indices.flatMap { number ->
            fun with(other: JsonElement?) =
                JsonArray(element.take(number) + listOfNotNull(other) + element.drop(number + 1))
            others(element[number]).map(::with) + changes(element[number], others).map(::with)
        }

        else -> emptyList()
    }

/** The names of all fields in [element]. */
internal fun fieldsOf(element: JsonElement): Set<String> = when (element) {
    is JsonObject -> element.keys + element.values.flatMap(::fieldsOf)
    is JsonArray -> element.flatMap(::fieldsOf).toSet()
    else -> emptySet()
}
