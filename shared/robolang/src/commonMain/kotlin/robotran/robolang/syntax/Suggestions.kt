package robotran.robolang.syntax

import robotran.language.isOtherOfSeries
import robotran.language.nearestWords
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.lowercaseKeyword
import robotran.robolang.words.written

/** The candidate that [word] is probably a misspelling of; null if none is similar. The first one wins a tie. */
internal fun suggestion(word: String, candidates: List<String>): String? = suggestions(word, candidates).firstOrNull()

/**
 * The candidate, in the words of English, that [word] in a program in [vocabulary] is probably a misspelling of; or that is
 * what [word] means in another language. Null if there is none.
 */
internal fun suggestionIn(vocabulary: Vocabulary, word: String, english: List<String>): String? {
    val elsewhere = Vocabulary.all.firstNotNullOfOrNull { other -> other.keyword(word)?.text?.takeIf { it in english } }
    if (elsewhere != null) return elsewhere
    val candidates = english.map { vocabulary.written(it) }
    return suggestion(word, candidates)?.let { english[candidates.indexOf(it)] }
}

/** The candidates that [word] is probably a misspelling of, none more likely than the others. */
internal fun suggestions(word: String, candidates: List<String>): List<String> {
    if (word.length > RobolangLimits.SUGGESTION_CHARACTERS) return emptyList()
    val lowercase = lowercaseKeyword(word)
    val others = candidates.filterNot { isOtherOfSeries(word, it) }
    return nearestWords(lowercase, others, errors = lowercase.length / LETTERS_FOR_A_SLIP)
}

/** One slip is forgiven per three letters, since short words are often similar by chance. */
private const val LETTERS_FOR_A_SLIP = 3
