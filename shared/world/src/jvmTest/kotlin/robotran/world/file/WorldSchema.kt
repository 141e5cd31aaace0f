package robotran.world.file

import io.github.optimumcode.json.schema.JsonSchema
import io.github.optimumcode.json.schema.OutputCollector
import io.github.optimumcode.json.schema.ValidationError
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject

/** The schema of world files, `worlds/world.schema.json`. */
internal object WorldSchema {
    private val definition = Json.parseToJsonElement(schemaTexts.getValue("world.schema.json"))
    private val schema = JsonSchema.fromJsonElement(definition)

    /** A schema that rejects all unknown fields. */
    private val closedSchema = JsonSchema.fromJsonElement(closed(definition))

    /** The names of all fields in it. */
    val fields: Set<String> = fieldsOf(definition)

    /** Whether [world] follows the schema; stops at the first mistake. */
    fun accepts(world: JsonElement): Boolean = schema.validate(world, OutputCollector.flag()).valid

    fun mistakesIn(world: JsonElement): List<String> = diagnostics(schema, world)

    fun unknownIn(world: JsonElement): List<String> = diagnostics(closedSchema, world)

    private fun diagnostics(schema: JsonSchema, world: JsonElement): List<String> {
        val diagnostics = mutableListOf<ValidationError>()
        schema.validate(world, diagnostics::add)
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

        is JsonArray -> {
            JsonArray(element.map(::closed))
        }

        else -> {
            element
        }
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
