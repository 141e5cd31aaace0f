package robotran.robolang.words

import robotran.language.source.SourceSpan

/**
 * The words of a line of [source] in other words, each as its place asks for.
 *
 * @param leaves the words, names and signs of the line in order.
 * @param from the words of the program.
 * @param to those that are asked for.
 */
class KeywordPlaces(
    private val source: String,
    leaves: List<SourceSpan>,
    private val from: Vocabulary,
    private val to: Vocabulary,
) {
    private val texts = leaves.map { it.textIn(source) }
    private val keywords: List<Keyword?>
    private val places = leaves.withIndex().associate { it.value to it.index }

    init {
        val first = texts.firstOrNull()?.let(from::keyword)
        keywords = texts.map { from.keyword(it, first) }
    }

    /** The word at [leaf]; what is no keyword stays as it is. */
    fun written(leaf: SourceSpan): String {
        val text = leaf.textIn(source)
        val index = places[leaf] ?: return text
        val keyword = keywords[index] ?: return text
        return to.text(keyword, placeOf(index), from.rankOf(keyword, text))
    }

    /** [english], a keyword that may stand at [leaf], as it would be written there; another text stays as it is. */
    fun option(leaf: SourceSpan, english: String): String {
        val index = places[leaf]
        val keyword = Vocabulary.ENGLISH.keyword(english)
        if (index == null || keyword == null) return english
        return to.text(keyword, placeOf(index), Vocabulary.ENGLISH.rankOf(keyword, english))
    }

    private fun placeOf(index: Int) = WordPlace(
        isFirst = index == 0 && texts.size > 1,
        isBehindOne = texts.getOrNull(index - 1) == "1",
        next = keywords.getOrNull(index + 1),
    )
}
