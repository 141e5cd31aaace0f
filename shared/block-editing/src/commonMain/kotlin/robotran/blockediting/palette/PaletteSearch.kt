package robotran.blockediting.palette

import robotran.blockediting.messages.BlockMessages
import robotran.language.Language

/** What the help says about the words of the language. */
fun interface PaletteHelp {
    /** A sentence about [word]; null if there is none. */
    fun sentence(word: String, language: Language): String?
}

/**
 * Finds blocks by words of any language: their own words, the names of their groups, and what [help] says about them.
 * The blocks whose own words fit come first. Each word of [query] must fit; accents do not count, and a word fits if it
 * begins like the one that is searched for, such as `fahren` and `fährt`.
 */
fun searchPalette(query: String, blocks: List<PaletteBlock>, help: PaletteHelp): List<PaletteBlock> {
    val words = wordsOf(query)
    if (words.isEmpty()) return blocks
    return blocks.mapNotNull { block ->
        val entry = SearchEntry(block, help)
        entry.rank(words)?.let { block to it }
    }.sortedBy { it.second }.map { it.first }
}

private class SearchEntry(block: PaletteBlock, help: PaletteHelp) {
    private val own = wordsOf(block.template)
    private val offered = block.words.toList() + block.words.flatMap { word ->
        Language.entries.flatMap { wordsOf(help.sentence(word, it).orEmpty()) }
    }
    private val groups = Language.entries.flatMap { wordsOf(BlockMessages.of(it).group(block.group)) }

    /** How well the block fits, from 0; null if it does not. */
    fun rank(words: List<String>): Int? {
        val ranks = words.map { word ->
            when {
                own.any { it.startsWith(word) } -> 0
                groups.any { isLike(it, word) } -> 1
                offered.any { isLike(it, word) } -> 2
                else -> return null
            }
        }
        return ranks.max()
    }
}

private fun isLike(word: String, searched: String): Boolean {
    val common = word.commonPrefixWith(searched).length
    return common == searched.length || (common >= MIN_STEM && common >= searched.length - MAX_ENDING)
}

private fun wordsOf(text: String): List<String> =
    text.lowercase().map { ACCENTS[it] ?: it }.joinToString("").split(BETWEEN_WORDS).filter { it.isNotEmpty() }

private val BETWEEN_WORDS = Regex("[^\\p{L}\\p{N}]+")

private val ACCENTS = mapOf(
    'á' to 'a',
    'ä' to 'a',
    'é' to 'e',
    'í' to 'i',
    'ñ' to 'n',
    'ó' to 'o',
    'ö' to 'o',
    'ú' to 'u',
    'ü' to 'u',
    'ß' to 's',
)

/** The length from which words count as alike that differ in their endings only. */
private const val MIN_STEM = 4

private const val MAX_ENDING = 2
