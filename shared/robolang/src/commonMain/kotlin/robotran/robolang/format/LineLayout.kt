package robotran.robolang.format

import robotran.language.source.SourceRange
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.TokenKind
import robotran.robolang.words.lowercaseKeyword

/** Formats the tokens of one line; [names] are all occurrences of names in the program. */
internal class LineLayout(names: List<Name>) {
    private val places: Map<SourceRange, Name> = names.associateBy { it.range }
    private val firstSpellings: Map<String, String> = names.asReversed().associate { it.key to it.text }

    fun isName(token: Token): Boolean = token.range in places

    fun textOf(tokens: List<Token>): String = buildString {
        tokens.forEachIndexed { position, token ->
            if (position > 0 && isApart(tokens, position)) append(' ')
            append(spelled(token, tokens.getOrNull(position + 1)))
        }
    }

    private fun spelled(token: Token, next: Token?): String {
        val name = places[token.range]
        return when {
            token.kind != TokenKind.WORD -> token.text
            name == null -> if (token.keyword == null) token.text.uppercase() else lowercaseKeyword(token.text)
            next?.kind == TokenKind.OPEN_BRACKET && BuiltIn.of(name.key) != null -> name.key
            else -> firstSpellings.getValue(name.key)
        }
    }

    /** Whether there is a space before the token at [position]. */
    private fun isApart(tokens: List<Token>, position: Int): Boolean {
        val before = tokens[position - 1]
        return when (tokens[position].kind) {
            TokenKind.COMMA, TokenKind.CLOSE_BRACKET, TokenKind.CLOSE_LIST -> false
            TokenKind.OPEN_BRACKET -> !isName(before) && !isOpening(before) && !isSign(tokens, position - 1)
            TokenKind.OPEN_LIST -> !endsList(before) && !isOpening(before) && !isSign(tokens, position - 1)
            TokenKind.MINUS -> !isOpening(before)
            else -> !isOpening(before) && !isSign(tokens, position - 1)
        }
    }

    private fun isOpening(token: Token): Boolean =
        token.kind == TokenKind.OPEN_BRACKET || token.kind == TokenKind.OPEN_LIST

    private fun endsList(token: Token): Boolean =
        isName(token) || token.kind == TokenKind.CLOSE_BRACKET || token.kind == TokenKind.CLOSE_LIST

    /** Whether [token] is the letter of a motor, as in `turned A`. */
    private fun isLetter(token: Token): Boolean = token.kind == TokenKind.WORD && token.keyword == null

    /** Whether the token at [position] is a unary minus. */
    private fun isSign(tokens: List<Token>, position: Int): Boolean {
        if (tokens[position].kind != TokenKind.MINUS) return false
        val before = tokens.getOrNull(position - 1) ?: return true
        return !endsList(before) && !isLetter(before) && before.kind != TokenKind.NUMBER &&
            before.keyword?.endsValue != true
    }
}
