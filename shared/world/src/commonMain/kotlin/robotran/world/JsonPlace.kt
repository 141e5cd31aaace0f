package robotran.world

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * A value in a JSON file that knows where it is. Whatever is not as it is asked for ends the reading with a [WorldRefusal]
 * that names the place.
 *
 * @property path such as `walls[2].from.x`; empty for the whole file.
 */
internal class JsonPlace(private val element: JsonElement, val path: String) {
    fun member(name: String): JsonPlace = optionalMember(name) ?: throw WorldRefusal("The world file lacks ${pathOf(name)}.")

    /** The member [name], or null if this has none. */
    fun optionalMember(name: String): JsonPlace? {
        val members = element as? JsonObject ?: refuse("must be an object in braces")
        return members[name]?.let { JsonPlace(it, pathOf(name)) }
    }

    /** The places of a list of at most [maximum] values. */
    fun items(maximum: Int): List<JsonPlace> {
        val items = element as? JsonArray ?: refuse("must be a list in square brackets")
        if (items.size > maximum) refuse("has ${items.size} entries, but at most $maximum are allowed")
        return items.mapIndexed { number, item -> JsonPlace(item, "$path[$number]") }
    }

    /** A text of one to [maximum] characters, all of them visible. */
    fun text(maximum: Int): String {
        val text = textOrNull() ?: refuse("must be a text in quotes")
        if (text.isBlank()) refuse("must not be empty")
        if (text.length > maximum) refuse("must not have more than $maximum characters")
        if (text.any { it.isISOControl() }) refuse("must be one line of ordinary characters")
        return text
    }

    fun textOrNull(): String? = (element as? JsonPrimitive)?.takeIf { it.isString }?.content

    fun number(range: ClosedRange<Double>): Double {
        val number = numberOrNull() ?: refuse("must be a number")
        if (number !in range) refuse("must be from ${plain(range.start)} to ${plain(range.endInclusive)}")
        return number
    }

    /** A whole number from 0 to the largest `Int`. */
    fun wholeNumber(): Int {
        val number = numberOrNull() ?: refuse("must be a number")
        if (number != number.toInt().toDouble() || number < 0) refuse("must be a whole number from 0 to ${Int.MAX_VALUE}")
        return number.toInt()
    }

    private fun numberOrNull(): Double? =
        (element as? JsonPrimitive)?.takeIf { it !is JsonNull && !it.isString }?.let { readDecimal(it.content) }

    private fun pathOf(name: String) = if (path.isEmpty()) name else "$path.$name"

    private fun refuse(reason: String): Nothing = throw WorldRefusal("The world file${if (path.isEmpty()) "" else "'s $path"} $reason.")

    // All limits are whole or have one decimal; Double.toString would write them differently from platform to platform.
    private fun plain(limit: Double): String = if (limit == limit.toInt().toDouble()) limit.toInt().toString() else limit.toString()
}
