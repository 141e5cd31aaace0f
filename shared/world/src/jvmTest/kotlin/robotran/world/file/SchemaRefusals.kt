package robotran.world.file

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
 * How many copies of [world] with one wrong value the schema refuses. Fails if the reader accepts one of them. The time
 * grows with the square of the world's length: the validator goes through all of it for each value.
 */
internal fun countRefused(world: JsonElement): Int {
    val whole = withoutDecimals(world)
    assertEquals(emptyList(), WorldSchema.errorsIn(whole))
    val refused = changes(whole, ::wrongValues).filterNot(WorldSchema::accepts)
    for (changed in refused) {
        val text = writeCompactJson(changed)
        if (readWorld(
                text,
                Language.ENGLISH,
            ) !is WorldFileResult.Failure
        ) {
            fail("${WorldSchema.errorsIn(changed)}\n$text")
        }
    }
    return refused.size
}

/** The validator takes ten times as long for a decimal number: it tries to read an integer first. */
private fun withoutDecimals(element: JsonElement): JsonElement = when (element) {
    is JsonObject -> JsonObject(element.mapValues { withoutDecimals(it.value) })
    is JsonArray -> JsonArray(element.map(::withoutDecimals))

    is JsonPrimitive -> element.takeIf { !it.isString }?.doubleOrNull?.takeIf { abs(it) >= 1 }
        ?.let { JsonPrimitive(it.toLong()) } ?: element
}
