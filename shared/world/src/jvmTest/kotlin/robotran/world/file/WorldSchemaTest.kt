package robotran.world.file

import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.take
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import robotran.json.writeCompactJson
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.test.fail

/** The schema and the reader agree on a file, as far as a schema can express the rules. */
class WorldSchemaTest {
    private val full = Json.parseToJsonElement(FULL_WORLD)
    private val worlds = arbitraryWorlds().take(50, RandomSource.seeded(2005)).map(::elementOf).toList()

    @Test
    fun `every world that comes with Robotran follows the schema and has no field that it does not know`() {
        for ((name, text) in BuiltInWorlds.texts + documentedWorlds) {
            val world = Json.parseToJsonElement(text)
            assertEquals(emptyList(), WorldSchema.mistakesIn(world), name)
            assertEquals(emptyList(), WorldSchema.unknownIn(world), name)
        }
    }

    @Test
    fun `every field that is written is in the schema`() {
        assertEquals(emptyList(), WorldSchema.unknownIn(full))
        for (world in worlds) {
            assertEquals(emptyList(), WorldSchema.mistakesIn(world))
            assertEquals(emptyList(), WorldSchema.unknownIn(withoutUnknown(world)))
        }
    }

    @Test
    fun `every field of the schema is read`() {
        assertEquals(WorldSchema.fields, fieldsOf(full))
        for (changed in changes(full) { listOf(JsonObject(mapOf("strange" to JsonNull))) }) {
            assertIs<WorldFileResult.Rejected>(readWorld(writeCompactJson(changed)), writeCompactJson(changed))
        }
    }

    @Test
    fun `what the schema refuses is refused`() {
        var refused = 0
        // The validator takes ten times as long for a decimal number: it tries to read an integer first.
        for (world in (worlds.take(3) + full).map(::withoutDecimals)) {
            assertEquals(emptyList(), WorldSchema.mistakesIn(world))
            for (changed in changes(world) { others(it) }) {
                if (!WorldSchema.accepts(changed)) {
                    refused++
                    val text = writeCompactJson(changed)
                    if (readWorld(text) !is WorldFileResult.Rejected) {
                        fail("${WorldSchema.mistakesIn(changed)}\n$text")
                    }
                }
            }
        }
        assertTrue(refused > 10_000, "$refused were refused")
    }

    /** Wrong values; null removes the value. */
    private fun others(value: JsonElement): List<JsonElement?> = listOf(
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

    /** Copies of [element] with each of its values replaced by each of [others]. */
    private fun changes(element: JsonElement, others: (JsonElement) -> List<JsonElement?>): List<JsonElement> =
        when (element) {
            is JsonObject -> element.filterKeys { !it.startsWith("_") }.flatMap { (name, value) ->
                val replaced = others(value).map { other ->
                    JsonObject(
                        if (other == null) {
                            element - name
                        } else {
                            element + (name to other)
                        },
                    )
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

    /** Arbitrary unknown fields begin with an underscore. */
    private fun withoutUnknown(element: JsonElement): JsonElement = when (element) {
        is JsonObject -> JsonObject(element.filterKeys { !it.startsWith("_") }.mapValues { withoutUnknown(it.value) })
        is JsonArray -> JsonArray(element.map(::withoutUnknown))
        else -> element
    }

    private fun withoutDecimals(element: JsonElement): JsonElement = when (element) {
        is JsonObject -> JsonObject(element.mapValues { withoutDecimals(it.value) })

        is JsonArray -> JsonArray(element.map(::withoutDecimals))

        is JsonPrimitive -> element.takeIf { !it.isString }?.doubleOrNull?.takeIf { abs(it) >= 1 }
            ?.let { JsonPrimitive(it.toLong()) } ?: element
    }

    private fun fieldsOf(element: JsonElement): Set<String> = when (element) {
        is JsonObject -> element.keys + element.values.flatMap(::fieldsOf)
        is JsonArray -> element.flatMap(::fieldsOf).toSet()
        else -> emptySet()
    }
}
