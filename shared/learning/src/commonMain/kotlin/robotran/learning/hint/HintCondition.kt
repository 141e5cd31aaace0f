package robotran.learning.hint

/**
 * What may have gone wrong in a try. A pure function of the [Attempt].
 *
 * @property phrase its name in the heading `## When ...` of a lesson, such as `pen never down`.
 */
class HintCondition internal constructor(val phrase: String, private val find: (Attempt) -> HintMatch?) {
    /** Where and how [attempt] shows it; null if it does not. */
    fun match(attempt: Attempt): HintMatch? = find(attempt)

    override fun toString(): String = phrase

    companion object {
        /** The phrase for a try whose program reaches the goals only in the other place of a lesson. */
        const val AGAIN = "again"

        /** The condition with this [phrase]; null if there is none. */
        fun of(phrase: String): HintCondition? {
            val words = phrase.substringAfter(ARGUMENT, "").trim()
            return when (phrase.substringBefore(ARGUMENT)) {
                phrase -> commonConditions.firstOrNull { it.phrase == phrase }
                WORD_MISSING -> wordMissing(phrase, words)
                WORD_USED -> wordUsed(phrase, words)
                else -> null
            }
        }

        private const val ARGUMENT = ": "
    }
}

/**
 * @property line the line of the program that a [HintCondition] was found at, from 1; null if it concerns no line.
 * @property word the word that is missing; null if it is about something else.
 */
data class HintMatch(val line: Int? = null, val word: String? = null)

internal const val WORD_MISSING = "word missing"
internal const val WORD_USED = "word used"

/** The conditions that every lesson knows, in the order in which they are tried. */
val commonConditions: List<HintCondition> = firstConditions + lineConditions + runConditions
