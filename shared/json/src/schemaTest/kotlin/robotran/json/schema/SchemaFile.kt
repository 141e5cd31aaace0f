package robotran.json.schema

import io.github.optimumcode.json.schema.JsonSchema
import io.github.optimumcode.json.schema.OutputCollector
import io.github.optimumcode.json.schema.ValidationError
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject

/** A JSON Schema; every `$ref` in it must lead to a place in it. */
internal class SchemaFile(definition: JsonElement) {
    private val schema = JsonSchema.fromJsonElement(definition)

    /** A schema that rejects all unknown fields. */
    private val closedSchema = JsonSchema.fromJsonElement(closed(definition))

    /** The names of all fields in it. */
    val fields: Set<String> = fieldsOf(definition)

    /** Whether [file] follows the schema; stops at the first mistake. */
    fun accepts(file: JsonElement): Boolean = schema.validate(file, OutputCollector.flag()).valid

    fun errorsIn(file: JsonElement): List<String> = diagnostics(schema, file)

    fun unknownIn(file: JsonElement): List<String> = diagnostics(closedSchema, file)

    private fun diagnostics(schema: JsonSchema, file: JsonElement): List<String> {
        val diagnostics = mutableListOf<ValidationError>()
        schema.validate(file, diagnostics::add)
        return diagnostics.map { "${it.objectPath}: ${it.message}" }
    }

    private fun closed(element: JsonElement): JsonElement = when (element) {
        is JsonObject -> {
            val inner = element.mapValues { closed(it.value) }
            JsonObject(
                if (element["type"] == JsonPrimitive("object")) {
                    inner + ("unevaluatedProperties" to JsonPrimitive(false))
                } else {
                    inner
                },
            )
        }

        is JsonArray -> JsonArray(element.map(::closed))
        else -> element
    }

    private fun fieldsOf(element: JsonElement): Set<String> = when (element) {
        is JsonObject -> element.flatMap { (name, value) ->
            if (name == "properties") {
                value.jsonObject.keys + value.jsonObject.values.flatMap(::fieldsOf)
            } else {
                fieldsOf(value)
            }
        }.toSet()

        is JsonArray -> element.flatMap(::fieldsOf).toSet()
        else -> emptySet()
    }
}
