package robotran.json

import robotran.language.editDistance

/**
 * What a reader has asked of the objects of a file. What it has asked for is what it knows, so this tells misspelt fields
 * without a list of all names.
 */
internal class JsonQuestions(private val pathOf: (JsonPath) -> JsonPath = { it }) {
    private val asked = mutableListOf<JsonCursor>()
    private val parts = mutableListOf<JsonQuestions>()

    fun add(cursor: JsonCursor) {
        asked += cursor
    }

    /** Questions about a part of the file in another form; [pathOf] tells the path in the file. */
    fun ofPart(pathOf: (JsonPath) -> JsonPath) = JsonQuestions(pathOf).also { parts += it }

    /** Fields that nobody has asked for, but whose names are near known ones, in the order of reading. */
    fun misspelt(): List<MisspeltField> {
        val own = asked.asSequence().flatMap { cursor ->
            cursor.names.asSequence().filter { it !in cursor.knownNames }.mapNotNull { name ->
                nearest(name, cursor)?.let { MisspeltField(pathOf(cursor.path + JsonStep.Member(name)), it) }
            }
        }
        return (own + parts.asSequence().flatMap { it.misspelt() }).take(JsonLimits.MAXIMUM_WARNINGS).toList()
    }

    /** Of several near names the one that the object lacks. */
    private fun nearest(name: String, cursor: JsonCursor): String? = cursor.knownNames.filter { isNear(name, it) }
        .minWithOrNull(compareBy({ it in cursor.names }, { editDistance(name, it) }))
}

/** @property known the name that is probably meant. */
internal class MisspeltField(val path: JsonPath, val known: String)

/**
 * Whether [written] is probably a misspelt [known]: `tsk`, `Time_Limit`, `color`. Short names have no near ones, and
 * neither have those that begin with a sign, as notes of other programs do: `_title`, `$schema`.
 */
internal fun isNear(written: String, known: String): Boolean {
    if (written.firstOrNull()?.isLetter() != true) return false
    if (written.length > known.length + MAXIMUM_SLIPS + 1) return false
    val one = plain(written)
    val other = plain(known)
    val slips = when {
        other.length < LETTERS_FOR_ONE -> 0
        other.length < LETTERS_FOR_TWO -> 1
        else -> MAXIMUM_SLIPS
    }
    return one == other || (slips > 0 && editDistance(one, other) <= slips)
}

/** In small letters, without what joins words. */
private fun plain(name: String): String = name.lowercase().filter { it !in JOINTS }

private const val JOINTS = "_- "
private const val LETTERS_FOR_ONE = 3
private const val LETTERS_FOR_TWO = 6
private const val MAXIMUM_SLIPS = 2
