package robotran.robolang

import robotran.robolang.check.BuiltIn
import robotran.robolang.syntax.Keyword

/** The words that Robolang knows, in lower case, for an editor that offers them. */
object RobolangWords {
    /** The words that a line can begin with. */
    val commands: List<String> = Keyword.COMMANDS.filter { it != Keyword.LEFT && it != Keyword.RIGHT }.map { it.text }

    /** All words of the language. */
    val keywords: List<String> = Keyword.entries.map { it.text }

    /** The functions that are built in, with the number of values that each takes. */
    val functions: Map<String, Int> = BuiltIn.entries.associate { it.text to it.parameters }
}
