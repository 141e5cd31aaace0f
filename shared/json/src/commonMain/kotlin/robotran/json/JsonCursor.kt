package robotran.json

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.messages.reason
import robotran.language.Language

/**
 * A value in a JSON file that knows its path. A value of the wrong type or range throws a [JsonValidationException]
 * with the path.
 */
class JsonCursor internal constructor(
    val element: JsonElement,
    val path: JsonPath,
    internal val questions: JsonQuestions,
) {
    private var asked: MutableMap<String, JsonCursor>? = null
    private var known: MutableSet<String>? = null
    private var restTaken = false

    fun member(name: String): JsonCursor = optional(name) ?: run {
        val near = members.keys.firstOrNull { it !in known.orEmpty() && isNear(it, name) }
        val reason = reason { if (near == null) missing() else missingBut(near) }
        throw JsonValidationException(path + JsonStep.Member(name), reason)
    }

    /** The member [name]; null if it is missing. */
    fun optional(name: String): JsonCursor? {
        if (!has(name)) return null
        val places = asked ?: mutableMapOf<String, JsonCursor>().also { asked = it }
        return places.getOrPut(name) {
            JsonCursor(members.getValue(name), path + JsonStep.Member(name), questions)
        }
    }

    /** Whether there is a member [name]. Asking makes the name known: others may be misspellings of it. */
    fun has(name: String): Boolean {
        val isThere = name in members
        val names = known ?: mutableSetOf<String>().also {
            known = it
            questions.add(this)
        }
        names += name
        return isThere
    }

    /** The names of all members, in file order. */
    val names: Set<String> get() = members.keys

    /** The names that were asked for, also those of no member. */
    internal val knownNames: Set<String> get() = known.orEmpty()

    /**
     * A cursor for [element] in place of this one's, such as the same in a newer version of the format.
     *
     * @param pathInFile the path in the file of what is at a path in [element].
     */
    fun with(element: JsonElement, pathInFile: (JsonPath) -> JsonPath) =
        JsonCursor(element, path, questions.ofPart(pathInFile))

    /**
     * The members that have not been read. The name of an object that was read, but without its own rest, holds the
     * unread members of that object. [withRest] restores them.
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

    /** The items of a list whose size must be in [count]. */
    fun items(count: IntRange): List<JsonCursor> {
        val items = element as? JsonArray ?: refuse(reason { mustBeList() })
        if (items.size > count.last) refuse(reason { tooManyEntries(items.size, count.last) })
        if (items.size < count.first) refuse(reason { tooFewEntries(items.size, count.first) })
        return items.mapIndexed { number, item -> JsonCursor(item, path + JsonStep.Item(number), questions) }
    }

    /**
     * A string of at most [maximum] visible characters, not blank unless [mayBeEmpty], one line unless [severalLines].
     */
    fun text(maximum: Int, mayBeEmpty: Boolean = false, severalLines: Boolean = false): String {
        val text = textOrNull() ?: refuse(reason { mustBeText() })
        if (!mayBeEmpty && text.isBlank()) refuse(reason { mustNotBeEmpty() })
        if (text.length > maximum) refuse(reason { tooManyCharacters(maximum) })
        val isOrdinary =
            text.none { it.isISOControl() && !(severalLines && it == '\n') } &&
                text.indices.none { isUnpairedSurrogate(text, it) }
        if (!isOrdinary) refuse(reason { if (severalLines) mustBeOrdinary() else mustBeOneOrdinaryLine() })
        return text
    }

    /** Any string of at most [maximum] characters, such as one of several lines. */
    fun longText(maximum: Int): String {
        val text = textOrNull() ?: refuse(reason { mustBeText() })
        if (text.length > maximum) refuse(reason { tooManyCharacters(maximum) })
        if (text.indices.any { isUnpairedSurrogate(text, it) }) refuse(reason { mustBeOrdinary() })
        return text
    }

    val isNull: Boolean get() = element is JsonNull

    /** The string, or null for another type. */
    fun textOrNull(): String? = (element as? JsonPrimitive)?.takeIf { it.isString }?.content

    fun number(range: ClosedRange<Double>): Double {
        val number = numberOrNull() ?: refuse(reason { mustBeNumber() })
        if (number !in range) refuse(reason { mustBeFrom(writeDecimal(range.start), writeDecimal(range.endInclusive)) })
        return number
    }

    fun wholeNumber(range: IntRange): Int {
        val number = numberOrNull() ?: refuse(reason { mustBeNumber() })
        val isWhole = number == number.toInt().toDouble()
        if (!isWhole || number.toInt() !in range) {
            refuse(reason { mustBeWholeFrom(range.first.toLong(), range.last.toLong()) })
        }
        return number.toInt()
    }

    /** The same as a `Long`. */
    fun longNumber(range: LongRange): Long {
        val number = numberOrNull() ?: refuse(reason { mustBeNumber() })
        if (number != number.toLong().toDouble() || number.toLong() !in range) {
            refuse(reason { mustBeWholeFrom(range.first, range.last) })
        }
        return number.toLong()
    }

    fun flag(): Boolean = when ((element as? JsonPrimitive)?.takeIf { !it.isString }?.content) {
        "true" -> true
        "false" -> false
        else -> refuse(reason { mustBeTrueOrFalse() })
    }

    /** The value for one of a few keywords. */
    fun <T> choice(words: Map<String, T>): T = words[textOrNull()] ?: refuse(reason { mustBeOneOf(words.keys) })

    /** Stops reading with an error; [reason], in any language, follows the path: `must be a number`. */
    fun refuse(reason: (Language) -> String): Nothing = throw JsonValidationException(path, reason)

    /** Stops reading with an error that [sentence], in any language, describes by itself. */
    fun refuseInSentence(sentence: (Language) -> String): Nothing =
        throw JsonValidationException(path, JsonValidationException.Form.SENTENCE, sentence)

    /** The same, but names only the line, since [sentence] says what is there. */
    fun refuseLine(sentence: (Language) -> String): Nothing =
        throw JsonValidationException(path, JsonValidationException.Form.WHOLE, sentence)

    private val members: JsonObject get() = element as? JsonObject ?: refuse(reason { mustBeObject() })

    private fun numberOrNull(): Double? =
        (element as? JsonPrimitive)?.takeIf { it !is JsonNull && !it.isString }?.let { readDecimal(it.content) }
}
