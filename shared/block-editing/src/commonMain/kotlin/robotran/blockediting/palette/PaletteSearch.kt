package robotran.blockediting.palette

import robotran.blockediting.messages.BlockMessages
import robotran.language.Language
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.written

/** What the help says about the words of the language. */
fun interface PaletteHelp {
    /** A sentence about [word]; null if there is none. */
    fun sentence(word: String, language: Language): String?
}

/**
 * Finds blocks by words of any language: their own words, the names of their groups, and what [help] says about them.
 * The best fit comes first, see [SearchFit]. Each word of [query] must fit; accents do not count, and a word of the help
 * fits if it begins like the one that is searched for, such as `fahren` and `fährt`.
 */
fun searchPalette(query: String, blocks: List<PaletteBlock>, help: PaletteHelp): List<PaletteBlock> {
    val words = wordsOf(query)
    if (words.isEmpty()) return blocks
    return blocks.mapNotNull { block ->
        val entry = SearchEntry(block, help)
        entry.fit(words)?.let { block to it }
    }.sortedBy { it.second }.map { it.first }
}

/** How well a block fits what is searched for, the best first. */
private enum class SearchFit {
    /** A line of the block says just that. */
    WHOLE,

    /** A line of the block begins with these words. */
    FIRST_WORDS,

    /** The block has these words. */
    WORDS,

    /** Words of the block begin like that. */
    BEGINNINGS,

    /** Pupils say so, in one of the languages. */
    SYNONYM,

    /** Its group is called so. */
    GROUP,

    /** Its menus, or the help on its words, say so. */
    HELP,
}

private class SearchEntry(block: PaletteBlock, help: PaletteHelp) {
    private val lines = Vocabulary.all.flatMap { it.written(block.template).lines().map(::wordsOf) }
    private val own = lines.flatten()
    private val synonyms = Language.entries.flatMap { wordsOf(BlockMessages.of(it).synonyms(block.id)) }
    private val offered = block.words.toList() + block.words.flatMap { word ->
        Language.entries.flatMap { wordsOf(help.sentence(word, it).orEmpty()) }
    }
    private val groups = Language.entries.flatMap { wordsOf(BlockMessages.of(it).group(block.group)) }

    /** How well the block fits; null if it does not. */
    fun fit(words: List<String>): SearchFit? = when {
        words in lines -> SearchFit.WHOLE
        lines.any { it.take(words.size) == words } -> SearchFit.FIRST_WORDS
        else -> words.map { fit(it) ?: return null }.max()
    }

    private fun fit(word: String): SearchFit? = when {
        word in own -> SearchFit.WORDS
        own.any { it.startsWith(word) } -> SearchFit.BEGINNINGS
        word in synonyms || (word.length >= MIN_STEM && synonyms.any { it.startsWith(word) }) -> SearchFit.SYNONYM
        groups.any { isLike(it, word) } -> SearchFit.GROUP
        offered.any { isLike(it, word) } -> SearchFit.HELP
        else -> null
    }
}

private fun isLike(word: String, searched: String): Boolean {
    val common = word.commonPrefixWith(searched).length
    return common == searched.length || (common >= MIN_STEM && common >= searched.length - MAX_ENDING)
}

private fun wordsOf(text: String): List<String> =
    text.lowercase().map { ACCENTS[it] ?: it }.joinToString("").split(BETWEEN_WORDS).filter { it.isNotEmpty() }

private val BETWEEN_WORDS = Regex("[^\\p{L}\\p{N}]+")

/** Each letter with those that count as it. */
private val ACCENTS: Map<Char, Char> = listOf(
    "aáàâãä",
    "cç",
    "eéèêë",
    "iíîï",
    "nñ",
    "oóôõö",
    "sß",
    "uúùûü",
).flatMap { plain -> plain.drop(1).map { it to plain.first() } }.toMap()

/** The length from which words count as alike that differ in their endings only. */
private const val MIN_STEM = 4

private const val MAX_ENDING = 2
