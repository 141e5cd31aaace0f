package robotran.robolang.syntax

import robotran.language.isOtherOfSeries
import robotran.language.nearestWords
import robotran.robolang.words.lowercaseKeyword

/** The candidate that [word] is probably a misspelling of; null if none is similar. The first one wins a tie. */
internal fun suggestion(word: String, candidates: List<String>): String? = suggestions(word, candidates).firstOrNull()

/** The candidates that [word] is probably a misspelling of, none more likely than the others. */
internal fun suggestions(word: String, candidates: List<String>): List<String> {
    if (word.length > RobolangLimits.SUGGESTION_CHARACTERS) return emptyList()
    val lowercase = lowercaseKeyword(word)
    val others = candidates.filterNot { isOtherOfSeries(word, it) }
    return nearestWords(lowercase, others, errors = lowercase.length / LETTERS_FOR_A_SLIP)
}

/** One slip is forgiven per three letters, since short words are often similar by chance. */
private const val LETTERS_FOR_A_SLIP = 3
