package robotran.robolang.check

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.suggestion
import robotran.robolang.syntax.suggestions
import robotran.robolang.words.Keyword
import robotran.robolang.words.lowercaseKeyword

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
    val meant = suggestion(name.text, known + VALUES + valuesOf(brick)) ?: MEANT[name.key]
    return meant?.let { scopes[it]?.name?.text ?: it }
}

private fun valuesOf(brick: BrickKind) =
    VALUES_OF_SOME.filter { it.isOn(brick) }.flatMap { listOfNotNull(it.text, it.singular) }

/** Whether [meant] by [name] is one of several names that are as likely. */
internal fun CheckContext.isOneOfSeveral(name: Name, meant: String, scopes: Scopes): Boolean {
    val known = scopes.keys.asSequence().take(COMPARED_NAMES).toList()
    val near = suggestions(name.text, known + VALUES + valuesOf(brick))
    return near.size > 1 && lowercaseKeyword(meant) in near
}

/** The routine that [name] probably means. */
internal fun CheckContext.nearestRoutine(name: Name): String? {
    if (suggestions++ >= SUGGESTIONS) return null
    val known = routines.keys.asSequence().take(COMPARED_NAMES).toList()
    val meant = suggestion(name.text, known + BuiltIn.entries.map { it.text })
    return meant?.let { routines[it]?.name?.text ?: it }
}
