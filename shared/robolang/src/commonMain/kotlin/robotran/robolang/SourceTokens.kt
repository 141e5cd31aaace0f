package robotran.robolang

import robotran.language.Language
import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.ScannedLine
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.TokenKind
import robotran.robolang.syntax.scan
import robotran.robolang.words.lowercaseKeyword

/** Splits one [line] into tokens like the scanner; skips unknown characters. Never throws. */
fun robolangTokens(line: String): List<CodeToken> =
    tokensOf(scan(line, DiagnosticSink(RobolangMessages.of(Language.ENGLISH))).first())

/**
 * The tokens of each line of [program]. A word that the program declares as a name is one on all its lines, see
 * [RobolangWords.isNewerWord]. Never throws.
 */
fun robolangTokensOfLines(program: String): List<List<CodeToken>> =
    scan(program, DiagnosticSink(RobolangMessages.of(Language.ENGLISH))).map(::tokensOf)

private fun tokensOf(line: ScannedLine): List<CodeToken> = (line.tokens + listOfNotNull(line.comment)).map {
    CodeToken(kindOf(it), it.range.column - 1, it.range.endColumn - 1)
}

private fun kindOf(token: Token): CodeTokenKind = when (token.kind) {
    TokenKind.WORD -> when {
        token.keyword != null -> CodeTokenKind.KEYWORD
        BuiltIn.of(lowercaseKeyword(token.text)) != null -> CodeTokenKind.BUILT_IN
        else -> CodeTokenKind.NAME
    }

    TokenKind.NUMBER -> CodeTokenKind.NUMBER
    TokenKind.TEXT -> CodeTokenKind.TEXT
    TokenKind.COMMENT -> CodeTokenKind.COMMENT
    else -> CodeTokenKind.SIGN
}
