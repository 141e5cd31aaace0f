package robotran.json.schema

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject

/**
 * A file with one field misspelt.
 *
 * @property name how it is spelt right.
 * @property without the same file without that field.
 */
internal class Misspelling(val file: JsonElement, val name: String, val written: String, val without: JsonElement)

/** [file] with each of its fields misspelt in turn. */
internal fun misspellingsOf(file: JsonElement): List<Misspelling> = when (file) {
    is JsonObject -> file.entries.flatMap { (name, value) ->
        val written = if (name.length < LETTERS_FOR_A_SLIP) name.uppercase() else name.dropLast(1)
        val others = file - name
        val own = Misspelling(JsonObject(others + (written to value)), name, written, JsonObject(others))
        val inner = misspellingsOf(value).map { slip ->
            Misspelling(
                JsonObject(file + (name to slip.file)),
                slip.name,
                slip.written,
                JsonObject(file + (name to slip.without)),
            )
        }
        if (name.any { it.isLetter() }) inner + own else inner
    }

    is JsonArray -> file.indices.flatMap { index ->
        misspellingsOf(file[index]).map { slip ->
            val with = { changed: JsonElement -> JsonArray(file.toMutableList().also { it[index] = changed }) }
            Misspelling(with(slip.file), slip.name, slip.written, with(slip.without))
        }
    }

    else -> emptyList()
}

/** Shorter names have no near ones but those with capitals. */
private const val LETTERS_FOR_A_SLIP = 4
