package robotran.robolang.words

import robotran.language.Language

/**
 * The words of Robolang in one language of people. A program is written in those of one language, which reading it tells:
 * see [vocabularyOf]. The grammar, its numbers and its signs are the same in all of them.
 */
class Vocabulary private constructor(val language: Language, column: List<List<Spelling>>) {
    private val spellings: Map<Keyword, List<Spelling>> = Keyword.entries.zip(column).toMap()
    private val keywords: Map<String, List<Keyword>> = buildMap<String, List<Keyword>> {
        for ((keyword, spelled) in spellings) {
            spelled.forEach { this[it.text] = (this[it.text].orEmpty() + keyword).distinct() }
        }
    }
    private val longest: Int = keywords.keys.maxOf { it.length }

    /** The keyword [word], ignoring case, in a line that begins with [first]; null for any other word. */
    internal fun keyword(word: String, first: Keyword? = null): Keyword? {
        if (word.length > longest) return null
        val candidates = keywords[lowercaseSpelling(word)] ?: return null
        return candidates.firstOrNull { (it in WITHIN_FOR) == (first == Keyword.FOR) } ?: candidates.first()
    }

    /** All that this language writes for [keyword]. */
    internal fun texts(keyword: Keyword): List<String> =
        spellings.getValue(keyword).filterNot { it.isBorrowed }.map { it.text }

    /** How [keyword] is usually written. */
    internal fun text(keyword: Keyword): String = spellings.getValue(keyword).first().text

    /** The rank of the spelling [word] of [keyword]; null if this language has only one, which has no rank. */
    internal fun rankOf(keyword: Keyword, word: String): Int? =
        spellings.getValue(keyword).first { it.text == lowercaseSpelling(word) }.rank

    /** How [keyword] is written at [place], in the spelling of [rank] where there are two. */
    internal fun text(keyword: Keyword, place: WordPlace, rank: Int? = null): String {
        val all = spellings.getValue(keyword)
        val usualRank = if (place.isBehindOne) 1 else 0
        val wanted = rank ?: usualRank
        val hasOne = all.first().rank == null
        val fitting = all.filter { it.rank == if (hasOne && wanted == usualRank) null else wanted }
            .ifEmpty { all.filter { it.rank == all.first().rank } }
        return (fitting.firstOrNull { it.isFor(place) } ?: fitting.first()).text
    }

    override fun toString(): String = "Vocabulary(${language.tag})"

    companion object {
        /** Those of all languages, English first. */
        val all: List<Vocabulary> by lazy {
            val rows = KEYWORD_TABLE.trim().lines().map { row -> row.split('|').map { it.trim() } }
            rows.first().mapIndexed { index, tag ->
                val language = Language.entries.first { it.tag == tag }
                Vocabulary(language, rows.drop(1).map { spellingsOf(it[index], it.first()) })
            }
        }

        val ENGLISH: Vocabulary get() = all.first()

        /** The words in [language]; English if there are none. */
        fun of(language: Language): Vocabulary = all.firstOrNull { it.language == language } ?: ENGLISH
    }
}

/** The keywords that share a spelling with another one in some languages, and are meant in lines that begin with `for`. */
private val WITHIN_FOR = setOf(Keyword.TO, Keyword.IN)

/**
 * Where a word stands in its line.
 *
 * @property isFirst whether it begins the line.
 * @property isBehindOne whether the number 1 stands before it.
 * @property next the keyword that follows it; null if none does.
 */
internal data class WordPlace(val isFirst: Boolean, val isBehindOne: Boolean, val next: Keyword?)

/**
 * One spelling of a keyword.
 *
 * @property rank 0 or 1 where a language has two, otherwise null.
 * @property isBorrowed whether it is English, for a difference that the language does not make.
 * @property isFor where it is written instead of the usual one.
 */
private class Spelling(
    val text: String,
    val rank: Int?,
    val isBorrowed: Boolean = false,
    val isFor: (WordPlace) -> Boolean = { false },
)

/** Reads a cell of [KEYWORD_TABLE]. English spellings without a counterpart in [cell] can be read, too. */
private fun spellingsOf(cell: String, english: String): List<Spelling> {
    val parts = cell.split(';').map { it.trim() }
    val usual = parts.first().split(',').map { it.trim() }
    val ranks = english.split(',').map { it.trim() }
    val own = usual.mapIndexed { index, text -> Spelling(text, index.takeIf { usual.size > 1 }) }
    val placed = parts.drop(1).map { placedSpelling(it, rank = if (usual.size > 1) 0 else null) }
    if (ranks.size == usual.size) return own + placed
    val foreign = ranks.mapIndexed { rank, text -> Spelling(text, rank, isBorrowed = true) }
    return own + placed + foreign.filter { spelling -> own.none { it.text == spelling.text } }
}

private fun placedSpelling(part: String, rank: Int?): Spelling {
    val words = part.split(' ')
    val isFor: (WordPlace) -> Boolean = when (words[1]) {
        "first" -> { place -> place.isFirst }
        else -> Keyword.entries.first { it.text == words[2] }.let { next -> { place -> place.next == next } }
    }
    return Spelling(words[0], rank, isFor = isFor)
}
