package robotran.world.file

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import robotran.json.writeCompactJson
import robotran.language.Language
import kotlin.math.abs
import kotlin.test.assertEquals
import kotlin.test.fail

/**
 * How many copies of [world] with one wrong value the schema refuses. Fails if the reader accepts one of them. The schema
 * sees a changed field in a world without the other fields, since the validator goes through all of a world each time.
 */
internal fun countRefused(world: JsonElement): Int {
    val whole = withoutDecimals(world) as JsonObject
    assertEquals(emptyList(), WorldSchema.errorsIn(whole))
    return whole.entries.sumOf { (name, value) ->
        changes(JsonObject(mapOf(name to value)), ::wrongValues).map { it as JsonObject }.count { changed ->
            val errors = WorldSchema.errorsIn(JsonObject(BARE_WORLD - name + changed))
            val text = writeCompactJson(JsonObject(whole - name + changed))
            if (errors.isNotEmpty() && readWorld(text, Language.ENGLISH) !is WorldFileResult.Failure) {
                fail("$errors\n$text")
            }
            errors.isNotEmpty()
        }
    }
}

/** A world with the fields that each needs. */
private val BARE_WORLD = Json.parseToJsonElement(
    """
    {
      "format": "robotran-world", "version": 2, "title": "Bare", "paper": { "width": 100, "height": 100 },
      "robots": [{ "start": { "x": 10, "y": 10, "heading": 0 } }]
    }
    """,
) as JsonObject

/** The validator takes ten times as long for a decimal number: it tries to read an integer first. */
private fun withoutDecimals(element: JsonElement): JsonElement = when (element) {
    is JsonObject -> JsonObject(element.mapValues { withoutDecimals(it.value) })
    is JsonArray -> JsonArray(element.map(::withoutDecimals))

    is JsonPrimitive -> element.takeIf { !it.isString }?.doubleOrNull?.takeIf { abs(it) >= 1 }
        ?.let { JsonPrimitive(it.toLong()) } ?: element
}
