package robotran.robolang.wording

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.TokenKind
import robotran.robolang.syntax.parse
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.lowercaseSpelling

/** A program in the words of another language: the result of [changeWords]. */
sealed interface ChangedWords {
    /**
     * The program does the same.
     *
     * @property text changing it back gives the same bytes, unless a keyword mixes capitals and small letters.
     */
    data class Success(val text: String) : ChangedWords

    /**
     * The program has names that are keywords in the other language.
     *
     * @property names as first written, in the order of the program.
     */
    data class NamesInTheWay(val names: List<String>) : ChangedWords
}

/**
 * The program [source] in the words of [to]: only its keywords change, never a name, a text, a comment, a space or a line
 * break. A program with mistakes is changed as far as it is understood. Never throws.
 */
fun changeWords(source: String, to: Vocabulary): ChangedWords {
    val parsed = parse(source, BrickKind.default, RobolangMessages.of(Language.ENGLISH))
    val from = parsed.vocabulary
    if (from === to) return ChangedWords.Success(source)
    val program = parsed.program
    val names = program.names.mapTo(mutableSetOf()) { it.range }
    val inTheWay = program.lines.flatMap { line ->
        val first = line.tokens.firstOrNull()?.keyword
        line.tokens.filter { token ->
            val other = if (token.kind == TokenKind.WORD) to.keyword(token.text, first) else null
            val stays = token.keyword == null || token.range in names
            other != null && stays &&
                !(token.range in names && (other.isFree || other.yields || token.text.length == 1))
        }
    }
    if (inTheWay.isNotEmpty()) {
        return ChangedWords.NamesInTheWay(
            inTheWay.map {
                it.text
            }.distinctBy(::lowercaseSpelling),
        )
    }
    return ChangedWords.Success(rewritten(source, program.lines, from, to) { it.range in names })
}
