package robotran.robolang

import robotran.language.Language
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.ScannedLine
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.TokenKind
import robotran.robolang.syntax.scan
import robotran.robolang.words.lowercaseKeyword

/**
 * A word, number or sign of a line, for syntax highlighting.
 *
 * @property start its first column, from 0.
 * @property end the column after its last character.
 */
data class SourceToken(val kind: SourceTokenKind, val start: Int, val end: Int)

enum class SourceTokenKind { KEYWORD, BUILT_IN, NAME, NUMBER, TEXT, SIGN, COMMENT }

/** Splits one [line] into tokens like the scanner; skips unknown characters. Never throws. */
fun robolangTokens(line: String): List<SourceToken> =
    tokensOf(scan(line, DiagnosticSink(RobolangMessages.of(Language.ENGLISH))).first())

/**
 * The tokens of each line of [program]. A word that the program declares as a name is one on all its lines, see
 * [RobolangWords.isNewerWord]. Never throws.
 */
fun robolangTokensOfLines(program: String): List<List<SourceToken>> =
    scan(program, DiagnosticSink(RobolangMessages.of(Language.ENGLISH))).map(::tokensOf)

private fun tokensOf(line: ScannedLine): List<SourceToken> = (line.tokens + listOfNotNull(line.comment)).map {
    SourceToken(kindOf(it), it.range.column - 1, it.range.endColumn - 1)
}

private fun kindOf(token: Token): SourceTokenKind = when (token.kind) {
    TokenKind.WORD -> when {
        token.keyword != null -> SourceTokenKind.KEYWORD
        BuiltIn.of(lowercaseKeyword(token.text)) != null -> SourceTokenKind.BUILT_IN
        else -> SourceTokenKind.NAME
    }

    TokenKind.NUMBER -> SourceTokenKind.NUMBER
    TokenKind.TEXT -> SourceTokenKind.TEXT
    TokenKind.COMMENT -> SourceTokenKind.COMMENT
    else -> SourceTokenKind.SIGN
}
