package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/**
 * The tokens of a program, one after the other, and the mistakes that can be seen from one token alone.
 *
 * @param textAt what is typed somewhere; null where nothing is.
 * @param isMacro whether a name stands for something else.
 */
internal class TokenReader(
    tokens: List<Token>,
    val sink: DiagnosticSink,
    val textAt: (SourceRange) -> String?,
    private val isMacro: (String) -> Boolean,
) {
    private val tokens = tokens.toMutableList()

    /** Whether all blocks are closed, so that one that seems to be open is not. */
    val isBalanced: Boolean by lazy { tokens.count { it.isSign("{") } <= tokens.count { it.isSign("}") } }

    var index = 0
        private set

    private var nesting = 0

    val token: Token get() = tokens[index]

    /** The token before; the first one at the beginning. */
    val previous: Token get() = tokens[maxOf(0, index - 1)]

    fun peek(distance: Int): Token = tokens[(index + distance).coerceIn(0, tokens.lastIndex)]

    fun advance(): Token = token.also { if (index < tokens.lastIndex) index++ }

    /** Reads on as if the token here were the word [keyword]. */
    fun readAs(keyword: Keyword) {
        tokens[index] = token.copy(kind = TokenKind.KEYWORD, text = keyword.text)
    }

    fun isSign(sign: String): Boolean = token.isSign(sign)

    fun isKeyword(keyword: Keyword): Boolean = token.keyword == keyword

    /** Skips [sign] if it is here. */
    fun accept(sign: String): Boolean = isSign(sign).also { if (it) advance() }

    fun accept(keyword: Keyword): Boolean = isKeyword(keyword).also { if (it) advance() }

    /** Where something that is missing should be: after the token before. */
    val gap: SourceRange get() = previous.range.end

    /** Whether the token here is typed in the line of [token]. */
    fun isInLineOf(token: Token): Boolean =
        this.token.range.line == token.range.line && this.token.range.file == token.range.file

    /** Skips the rest of the statement, as far as it is in the line of [first]; the last token of it. */
    fun skipLine(first: Token): Token {
        while (token.kind != TokenKind.END && isInLineOf(first) && ENDS.none { isSign(it) }) advance()
        return previous
    }

    /** A fix that inserts [text] at [gap]; null if a macro's text would have to change. */
    fun insertion(text: String): SourceFix? {
        val use = previous.macro?.outermost ?: return SourceFix(gap, text)
        return if (token.macro?.outermost === use) null else SourceFix(use.end.end, text)
    }

    /** Skips an opening bracket or brace. */
    fun opening(sign: String) {
        if (accept(sign)) return
        val code = if (sign == "{") NqcDiagnosticCode.MISSING_BLOCK else NqcDiagnosticCode.MISSING_BRACKET
        val message = if (sign == "{") sink.messages.missingBlock(previous.text) else sink.messages.missing(sign)
        fail(code, gap, message)
    }

    /** Skips the opening bracket of a condition. If it is missing, a fix puts what comes before a block in brackets. */
    fun openingOfCondition() {
        if (accept("(")) return
        failUnlessKnown()
        val place = gap
        val first = token
        val range = first.range.to(skipLine(first).range)
        val condition = textAt(range).takeIf { isSign("{") && first.macro?.parent == null }
        val fix = condition?.let { SourceFix(range, "($it)") }
        fail(NqcDiagnosticCode.MISSING_BRACKET, place, sink.messages.missing("("), fix)
    }

    /** Skips a closing bracket. */
    fun closing(sign: String) {
        if (accept(sign)) return
        if (isSign("=")) {
            fail(
                NqcDiagnosticCode.ASSIGNMENT_AS_VALUE,
                token.range,
                sink.messages.assignmentAsValue(),
                if (token.macro == null) SourceFix(token.range, "==") else null,
            )
        }
        failUnlessKnown()
        fail(NqcDiagnosticCode.MISSING_BRACKET, gap, sink.messages.missing(sign), insertion(sign))
    }

    /** Skips a semicolon. If it is missing where a statement can end, the next statement is read all the same. */
    fun semicolon() {
        if (accept(";")) return
        failUnlessKnown()
        if (!canEndHere()) unexpected()
        sink.report(NqcDiagnosticCode.MISSING_SEMICOLON, gap, sink.messages.missingSemicolon(), insertion(";"))
    }

    private fun canEndHere(): Boolean {
        val isOnOtherLine = token.range.line != previous.range.line || token.range.file != previous.range.file
        val begins = token.keyword?.group in STATEMENT_GROUPS
        return token.kind == TokenKind.END || isOnOtherLine || isSign("}") || begins
    }

    /** Fails at a token that is no part of the language. */
    private fun failUnlessKnown() {
        if (token.kind == TokenKind.UNKNOWN) {
            DecimalNumber.at(::peek)?.let { number -> failAt(number) }
            fail(NqcDiagnosticCode.UNKNOWN_CHARACTER, token.range, sink.messages.unknownCharacter(token.text))
        }
        if (token.kind == TokenKind.TEXT) {
            if (isMacro(token.text)) failAtQuotedName()
            fail(NqcDiagnosticCode.TEXT_AS_VALUE, token.range, sink.messages.textAsValue())
        }
        failAtDefinition(token)
        if (token.kind == TokenKind.SIGN && previous.isSign(";") && isInLineOf(previous)) failAtDefinition(previous)
    }

    private fun failAtQuotedName(): Nothing = fail(
        NqcDiagnosticCode.TEXT_AS_VALUE,
        token.range,
        sink.messages.quotedName(token.text),
        if (token.macro == null) SourceFix(token.range, token.text) else null,
    )

    /** Fails if [sign] comes from the definition of a macro, where it makes no sense. */
    private fun failAtDefinition(sign: Token) {
        val name = sign.macro?.name?.takeIf { sign.isSign(";") || sign.isSign("=") } ?: return
        val range = sign.definedAt?.takeIf { it.line > 0 && textAt(it) == sign.text } ?: return
        val message = sink.messages.signInDefinition(sign.text, name)
        val value = token.takeIf { it !== sign } ?: peek(1)
        val isFollowed = sign.isSign("=") && value.macro === sign.macro && value.definedAt?.line == range.line
        val end = if (isFollowed) checkNotNull(value.definedAt).column else range.endColumn
        // It does not end the statement, nor does another one right behind it.
        if (sign === token || isSign(";")) advance()
        fail(NqcDiagnosticCode.MACRO_SIGN, range, message, SourceFix(range.copy(endColumn = end), ""))
    }

    private fun failAt(number: DecimalNumber): Nothing {
        val hundredths = number.hundredths.takeIf { number.isTime }
        val message = if (hundredths == null) {
            sink.messages.decimalNumber()
        } else {
            sink.messages.decimalTime(number.text, hundredths)
        }
        val fix = hundredths?.takeIf { token.macro == null }?.let { SourceFix(number.range, "$it") }
        fail(NqcDiagnosticCode.UNKNOWN_CHARACTER, token.range, message, fix)
    }

    /** Fails because nothing that is written like this token can be here. */
    fun unexpected(): Nothing {
        failUnlessKnown()
        if (token.kind == TokenKind.END) {
            fail(NqcDiagnosticCode.UNEXPECTED_TOKEN, gap, sink.messages.unexpectedEnd())
        }
        val text = token.text.take(NqcLimits.QUOTED_CHARACTERS)
        fail(NqcDiagnosticCode.UNEXPECTED_TOKEN, token.range, sink.messages.unexpected(text))
    }

    /** Fails because a value should be here. */
    fun missingValue(): Nothing {
        failUnlessKnown()
        fail(NqcDiagnosticCode.MISSING_VALUE, gap, sink.messages.missingValue(previous.text))
    }

    /** Skips a name and returns it. */
    fun name(): Token {
        if (token.kind == TokenKind.NAME) return advance()
        failUnlessKnown()
        val word = token.keyword?.text
        val range = if (word != null) token.range else gap
        fail(NqcDiagnosticCode.MISSING_NAME, range, sink.messages.missingName(previous.text, word))
    }

    fun fail(code: NqcDiagnosticCode, range: SourceRange, message: String, fix: SourceFix? = null): Nothing {
        sink.report(code, range, message, fix)
        throw SyntaxFailure()
    }

    /** Reads something with [read] that can contain itself. */
    fun <T> nested(limit: Int, read: () -> T): T {
        if (nesting >= limit) {
            fail(NqcDiagnosticCode.NESTED_TOO_DEEPLY, token.range, sink.messages.nestedTooDeeply(limit))
        }
        nesting++
        try {
            return read()
        } finally {
            nesting--
        }
    }

    private companion object {
        val ENDS = setOf(";", "{", "}")
        val STATEMENT_GROUPS = setOf(KeywordGroup.STATEMENT, KeywordGroup.DECLARATION, KeywordGroup.UNIT)
    }
}
