package robotran.robolang.wording

import robotran.robolang.outline.LineOffsets
import robotran.robolang.syntax.ScannedLine
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.TokenKind
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.WordPlace
import robotran.robolang.words.lowercaseSpelling
import robotran.robolang.words.uppercaseSpelling

/**
 * [source] with the keywords of its [lines], apart from [isName], in other words. Nothing else changes, nor does a keyword
 * at a wrong place that would be read as another one there, such as `in` outside of a `for`.
 */
internal fun rewritten(
    source: String,
    lines: List<ScannedLine>,
    from: Vocabulary,
    to: Vocabulary,
    isName: (Token) -> Boolean,
): String = buildString(source.length) {
    val offsets = LineOffsets(source, lines)
    var position = 0
    for (line in lines) {
        line.tokens.forEachIndexed { index, token ->
            val keyword = token.keyword?.takeUnless {
                token.kind != TokenKind.WORD || token.text == "}" || isName(token)
            }
            val first = line.tokens.first().keyword.takeIf { index > 0 }
            val written = keyword?.let { to.text(it, placeIn(line.tokens, index), from.rankOf(it, token.text)) }
            if (written != null && to.keyword(written, first) == keyword) {
                val span = offsets.span(token.range)
                append(source, position, span.start)
                append(inCaseOf(token.text, written))
                position = span.end
            }
        }
    }
    append(source, position, source.length)
}

private fun placeIn(tokens: List<Token>, index: Int): WordPlace = WordPlace(
    isFirst = index == 0,
    isBehindOne = tokens.getOrNull(index - 1)?.text == "1",
    next = tokens.getOrNull(index + 1)?.keyword,
)

/** [word] with capitals where [model] has them: throughout, at its beginning, or nowhere. */
private fun inCaseOf(model: String, word: String): String = when {
    model == lowercaseSpelling(model) -> word
    model.length > 1 && model == uppercaseSpelling(model) -> uppercaseSpelling(word)
    model.first() == uppercaseSpelling(model).first() -> uppercaseSpelling(word.take(1)) + word.drop(1)
    else -> word
}
