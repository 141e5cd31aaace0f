package robotran.robolang

import robotran.robolang.check.BuiltIn
import robotran.robolang.diagnostic.Mistakes
import robotran.robolang.messages.EnglishMessages
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.TokenKind
import robotran.robolang.syntax.lowercaseKeyword
import robotran.robolang.syntax.scan

/**
 * A word, a number or a sign of a line, for an editor that colours them.
 *
 * @property start its first column, from 0.
 * @property end the column behind its last character.
 */
data class SourcePiece(
    val kind: SourcePieceKind,
    val start: Int,
    val end: Int,
)

enum class SourcePieceKind { KEYWORD, BUILT_IN, NAME, NUMBER, TEXT, SIGN, COMMENT }

/** Takes one [line] apart as the scanner does; what it does not know is left out. Never throws. */
fun robolangPieces(line: String): List<SourcePiece> {
    val scanned = scan(line, Mistakes(EnglishMessages)).first()
    return (scanned.tokens + listOfNotNull(scanned.comment)).map { SourcePiece(kindOf(it), it.range.column - 1, it.range.endColumn - 1) }
}

private fun kindOf(token: Token): SourcePieceKind = when (token.kind) {
    TokenKind.WORD -> when {
        token.keyword != null -> SourcePieceKind.KEYWORD
        BuiltIn.of(lowercaseKeyword(token.text)) != null -> SourcePieceKind.BUILT_IN
        else -> SourcePieceKind.NAME
    }

    TokenKind.NUMBER -> SourcePieceKind.NUMBER

    TokenKind.TEXT -> SourcePieceKind.TEXT

    TokenKind.COMMENT -> SourcePieceKind.COMMENT

    else -> SourcePieceKind.SIGN
}
