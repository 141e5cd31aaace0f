package robotran.robolang.check

import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.suggestion
import robotran.robolang.syntax.suggestions
import robotran.robolang.words.Keyword
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.lowercaseKeyword
import robotran.robolang.words.written

/** Keywords that have a value. */
private val VALUES = listOf("left bumper", "right bumper", "light", "timer", "battery", "true", "false")

/** Those that some bricks have. */
private val VALUES_OF_SOME = listOf(Keyword.DISTANCE, Keyword.LOUDNESS, Keyword.COLOUR)

/** Names that may be meant by a word that is a part of them. */
private val MEANT =
    mapOf("bumper" to "left bumper", "button" to "button run", "time" to "timer", "sensor" to "sensor 1")

/** The max number of names compared with an unknown one. */
private const val COMPARED_NAMES = 500

/** The max number of unknown names that get a suggestion, which bounds the time. */
private const val SUGGESTIONS = 200

/** The variable in [scopes] or the keyword with a value that [name] probably means. */
internal fun CheckContext.nearestName(name: Name, scopes: Scopes): String? {
    if (suggestions++ >= SUGGESTIONS) return null
    val known = scopes.keys.asSequence().take(COMPARED_NAMES).toList()
    val meant = suggestion(name.text, known + values()) ?: elsewhere(name) ?: MEANT[name.key]
    return meant?.let { scopes[it]?.name?.text ?: it }
}

/** What has a value on the brick, in the words of the program. */
private fun CheckContext.values(): List<String> =
    (VALUES + VALUES_OF_SOME.filter { it.isOn(brick) }.map { it.text }).map { diagnostics.vocabulary.written(it) }

/** The value that [name] is in the words of another language. */
private fun elsewhere(name: Name): String? =
    Vocabulary.all.firstNotNullOfOrNull { other -> other.keyword(name.text)?.text?.takeIf { it in VALUES } }

/** Whether [meant] by [name] is one of several names that are as likely. */
internal fun CheckContext.isOneOfSeveral(name: Name, meant: String, scopes: Scopes): Boolean {
    val known = scopes.keys.asSequence().take(COMPARED_NAMES).toList()
    val near = suggestions(name.text, known + values())
    return near.size > 1 && lowercaseKeyword(meant) in near
}

/** The routine that [name] probably means. */
internal fun CheckContext.nearestRoutine(name: Name): String? {
    if (suggestions++ >= SUGGESTIONS) return null
    val known = routines.keys.asSequence().take(COMPARED_NAMES).toList()
    val meant = suggestion(name.text, known + BuiltIn.entries.map { it.text })
    return meant?.let { routines[it]?.name?.text ?: it }
}
