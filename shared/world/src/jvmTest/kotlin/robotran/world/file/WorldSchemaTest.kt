package robotran.world.file

import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.take
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import robotran.json.writeCompactJson
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** The schema and the reader agree on a file, as far as a schema can express the rules. */
class WorldSchemaTest {
    private val full = Json.parseToJsonElement(FULL_WORLD.replaceFirst("\"lightSensor\"", "$DRAFT, \"lightSensor\""))
    private val worlds = arbitraryWorlds().take(50, RandomSource.seeded(2005)).map(::elementOf).toList()

    @Test
    fun `every world that comes with Robotran follows the schema and has no field that it does not know`() {
        for ((name, text) in BuiltInWorlds.texts + documentedWorlds) {
            val world = Json.parseToJsonElement(text)
            assertEquals(emptyList(), WorldSchema.errorsIn(world), name)
            assertEquals(emptyList(), WorldSchema.unknownIn(world), name)
        }
    }

    @Test
    fun `every field that is written is in the schema`() {
        assertEquals(emptyList(), WorldSchema.unknownIn(full))
        for (world in worlds) {
            assertEquals(emptyList(), WorldSchema.errorsIn(world))
            assertEquals(emptyList(), WorldSchema.unknownIn(withoutUnknown(world)))
        }
    }

    @Test
    fun `every field of the schema is read`() {
        assertEquals(WorldSchema.fields, fieldsOf(full))
        for (changed in changes(full) { listOf(JsonObject(mapOf("strange" to JsonNull))) }) {
            assertIs<WorldFileResult.Failure>(
                readWorld(writeCompactJson(changed), Language.ENGLISH),
                writeCompactJson(changed),
            )
        }
    }

    @Test
    fun `what the schema refuses is refused`() {
        val refused = countRefused(full)
        assertTrue(refused > 1_000, "$refused were refused")
    }

    /** Arbitrary unknown fields begin with an underscore. */
    private fun withoutUnknown(element: JsonElement): JsonElement = when (element) {
        is JsonObject -> JsonObject(element.filterKeys { !it.startsWith("_") }.mapValues { withoutUnknown(it.value) })
        is JsonArray -> JsonArray(element.map(::withoutUnknown))
        else -> element
    }

    private companion object {
        const val DRAFT = """"draft": { "title": "Draft", "pen": "A" }"""
    }
}
