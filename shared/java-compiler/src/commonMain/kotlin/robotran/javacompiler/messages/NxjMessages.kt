package robotran.javacompiler.messages

/** The messages about what an NXT with leJOS NXJ lacks or does in its own way. */
interface NxjMessages {
    /** What to use instead; a sentence or two. */
    fun insteadInNxj(remedy: NxjRemedy): String

    /** To write one of the pieces of [code] instead. */
    fun writeInNxj(code: List<String>): String

    /** A `for` with a colon goes through something that it cannot go through, such as a `Vector`. */
    fun onlyArraysAndLists(): String

    /** Two texts are compared with [operator], `==` or `!=`. */
    fun textsCompared(operator: String): String

    /** What to write to compare the letters of texts: [comparison]. */
    fun compareLetters(comparison: String): String
}
