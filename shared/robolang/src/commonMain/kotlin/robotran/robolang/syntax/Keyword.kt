package robotran.robolang.syntax

/**
 * The words of the language; they ignore case.
 *
 * @property text as Robolang spells it.
 * @property singular how else it may be written, for one second or one degree.
 */
internal enum class Keyword(val text: String, val singular: String? = null) {
    FORWARD("forward"),
    BACKWARD("backward"),
    TURN("turn"),
    PEN("pen"),
    REPEAT("repeat"),
    WAIT("wait"),
    BEEP("beep"),
    SHOW("show"),
    END("end"),
    LEFT("left"),
    RIGHT("right"),
    DOWN("down"),
    UP("up"),
    TIMES("times", "time"),
    CM("cm"),
    DEGREES("degrees", "degree"),
    SECONDS("seconds", "second"),
    MILLISECONDS("milliseconds", "millisecond"),
    ;

    companion object {
        /** The words that a line can begin with. */
        val COMMANDS: Set<Keyword> = setOf(FORWARD, BACKWARD, TURN, PEN, REPEAT, WAIT, BEEP, SHOW, END)

        private val bySpelling: Map<String, Keyword> =
            entries.flatMap { keyword -> listOfNotNull(keyword.text, keyword.singular).map { it to keyword } }.toMap()

        private val longestSpelling: Int = bySpelling.keys.maxOf { it.length }

        /** The keyword that [word] is, in capitals or not. */
        fun of(word: String): Keyword? = if (word.length > longestSpelling) null else bySpelling[lowercaseKeyword(word)]
    }
}

/** Keywords are plain ASCII, and so is their lower case: the platforms disagree about some other letters. */
internal fun lowercaseKeyword(word: String): String =
    buildString(word.length) { word.forEach { append(if (it in 'A'..'Z') it + ('a' - 'A') else it) } }
