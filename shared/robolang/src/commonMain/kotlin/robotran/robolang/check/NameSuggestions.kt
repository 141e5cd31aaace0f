package robotran.robolang.check

import robotran.robolang.syntax.Name
import robotran.robolang.syntax.suggestion

/** Words of the language that have a value. */
private val VALUES = listOf("left bumper", "right bumper", "light", "timer", "battery", "true", "false")

/** What may be meant by a word that stands for a part of these. */
private val MEANT =
    mapOf("bumper" to "left bumper", "button" to "button run", "time" to "timer", "sensor" to "sensor 1")

/** So many names are compared with one that is unknown; a longer list is no help to anybody. */
private const val COMPARED_NAMES = 500

/** How many unknown names get a suggestion at most, so that comparing them all takes bounded time. */
private const val SUGGESTIONS = 200

/** The variable in [scopes] that is probably meant by [name], or a word of the language that has a value. */
internal fun CheckContext.nearestName(name: Name, scopes: Scopes): String? {
    if (suggestions++ >= SUGGESTIONS) return null
    val known = scopes.keys.asSequence().take(COMPARED_NAMES).toList()
    val meant = suggestion(name.text, known + VALUES) ?: MEANT[name.key]
    return meant?.let { scopes[it]?.name?.text ?: it }
}

/** The routine that is probably meant by [name]. */
internal fun CheckContext.nearestRoutine(name: Name): String? {
    if (suggestions++ >= SUGGESTIONS) return null
    val known = routines.keys.asSequence().take(COMPARED_NAMES).toList()
    val meant = suggestion(name.text, known + BuiltIn.entries.map { it.text })
    return meant?.let { routines[it]?.name?.text ?: it }
}
