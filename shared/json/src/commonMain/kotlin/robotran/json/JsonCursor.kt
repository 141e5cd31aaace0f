package robotran.json

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.messages.told
import robotran.language.Language

/**
 * A value in a JSON file that knows where it is. Whatever is not as it is asked for ends the reading with a
 * [JsonValidationException] that names the place.
 */
class JsonCursor(val element: JsonElement, val path: JsonPath) {
    private var asked: MutableMap<String, JsonCursor>? = null
    private var restTaken = false

    fun member(name: String): JsonCursor =
        optional(name) ?: throw JsonValidationException(path + JsonStep.Member(name), told { missing() })

    /** The member [name], or null if this has none. */
    fun optional(name: String): JsonCursor? {
        val value = members[name] ?: return null
        val places = asked ?: mutableMapOf<String, JsonCursor>().also { asked = it }
        return places.getOrPut(name) { JsonCursor(value, path + JsonStep.Member(name)) }
    }

    /** The names of all members, in the order of the file. */
    val names: Set<String> get() = members.keys

    /**
     * The members that nobody has asked for; under the name of an object that somebody has asked for, but not for its
     * rest, what is left in that. [withRest] puts them back.
     */
    fun rest(): Map<String, JsonElement> {
        restTaken = true
        val members = element as? JsonObject ?: return emptyMap()
        return buildMap {
            for ((name, value) in members) {
                val place = asked?.get(name)
                if (place == null) {
                    put(name, value)
                } else if (!place.restTaken) {
                    place.rest().let { if (it.isNotEmpty()) put(name, JsonObject(it)) }
                }
            }
        }
    }

    /** The places of a list with so many values. */
    fun items(count: IntRange): List<JsonCursor> {
        val items = element as? JsonArray ?: refuse(told { mustBeList() })
        if (items.size > count.last) refuse(told { tooManyEntries(items.size, count.last) })
        if (items.size < count.first) refuse(told { tooFewEntries(items.size, count.first) })
        return items.mapIndexed { number, item -> JsonCursor(item, path + JsonStep.Item(number)) }
    }

    /** A text of at most [maximum] characters in one line, all of them visible; not a blank one unless [mayBeEmpty]. */
    fun text(maximum: Int, mayBeEmpty: Boolean = false, severalLines: Boolean = false): String {
        val text = textOrNull() ?: refuse(told { mustBeText() })
        if (!mayBeEmpty && text.isBlank()) refuse(told { mustNotBeEmpty() })
        if (text.length > maximum) refuse(told { tooManyCharacters(maximum) })
        val isOrdinary =
            text.none { it.isISOControl() && !(severalLines && it == '\n') } &&
                text.indices.none { isHalfCharacter(text, it) }
        if (!isOrdinary) refuse(told { if (severalLines) mustBeOrdinary() else mustBeOneOrdinaryLine() })
        return text
    }

    /** Any text at all of at most [maximum] characters, such as one of several lines. */
    fun longText(maximum: Int): String {
        val text = textOrNull() ?: refuse(told { mustBeText() })
        if (text.length > maximum) refuse(told { tooManyCharacters(maximum) })
        if (text.indices.any { isHalfCharacter(text, it) }) refuse(told { mustBeOrdinary() })
        return text
    }

    /** The text in quotes, or null if this is none. */
    fun textOrNull(): String? = (element as? JsonPrimitive)?.takeIf { it.isString }?.content

    fun number(range: ClosedRange<Double>): Double {
        val number = numberOrNull() ?: refuse(told { mustBeNumber() })
        if (number !in range) refuse(told { mustBeFrom(writeDecimal(range.start), writeDecimal(range.endInclusive)) })
        return number
    }

    fun wholeNumber(range: IntRange): Int {
        val number = numberOrNull() ?: refuse(told { mustBeNumber() })
        val isWhole = number == number.toInt().toDouble()
        if (!isWhole ||
            number.toInt() !in range
        ) {
            refuse(told { mustBeWholeFrom(range.first.toLong(), range.last.toLong()) })
        }
        return number.toInt()
    }

    /** The same beyond what an `Int` holds. */
    fun longNumber(range: LongRange): Long {
        val number = numberOrNull() ?: refuse(told { mustBeNumber() })
        if (number != number.toLong().toDouble() || number.toLong() !in range) {
            refuse(told { mustBeWholeFrom(range.first, range.last) })
        }
        return number.toLong()
    }

    fun flag(): Boolean = when ((element as? JsonPrimitive)?.takeIf { !it.isString }?.content) {
        "true" -> true
        "false" -> false
        else -> refuse(told { mustBeTrueOrFalse() })
    }

    /** What one of a few words stands for. */
    fun <T> choice(words: Map<String, T>): T = words[textOrNull()] ?: refuse(told { mustBeOneOf(words.keys) })

    /** Ends the reading; [reason], in any language, is read behind the path: `must be a number`. */
    fun refuse(reason: (Language) -> String): Nothing = throw JsonValidationException(path, reason)

    /**
     * Refuses what the parser lets pass: words without quotes that are neither a number nor `true`, `false` or `null`.
     */
    internal fun checkLiterals() {
        when (element) {
            is JsonObject -> element.forEach { (name, value) ->
                if (hasLiterals(value)) JsonCursor(value, path + JsonStep.Member(name)).checkLiterals()
            }

            is JsonArray -> element.forEachIndexed { number, value ->
                if (hasLiterals(value)) JsonCursor(value, path + JsonStep.Item(number)).checkLiterals()
            }

            is JsonPrimitive -> if (hasLiterals(element)) refuse(told { mustBeKnownWord() })
        }
    }

    private fun hasLiterals(value: JsonElement): Boolean = when (value) {
        is JsonNull -> {
            false
        }

        is JsonPrimitive -> {
            !value.isString && value.content != "true" && value.content != "false" &&
                !isNumber(value.content)
        }

        else -> {
            true
        }
    }

    private val members: JsonObject get() = element as? JsonObject ?: refuse(told { mustBeObject() })

    private fun numberOrNull(): Double? =
        (element as? JsonPrimitive)?.takeIf { it !is JsonNull && !it.isString }?.let { readDecimal(it.content) }
}
