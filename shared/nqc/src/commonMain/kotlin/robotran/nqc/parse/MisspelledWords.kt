package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Signs
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.syntax.similarName

/**
 * Finds words of the language with other capitals or letters, and types of other languages.
 *
 * @param isName whether the program or the API has something of a name.
 */
internal class MisspelledWords(private val reader: TokenReader, private val isName: (String) -> Boolean) {
    private val sink = reader.sink

    /** Reports the token here if it is a word of the language that is written wrongly, and reads it as that word. */
    fun correct() {
        val token = reader.token
        if (token.kind != TokenKind.NAME || isName(token.text)) return
        val next = reader.peek(1)
        if (token.text in EXTRA_WORDS && (next.keyword?.group in DECLARING || next.text in EXTRA_WORDS)) {
            skipExtraWord(token, next)
        } else if (token.text in OTHER_TYPES && next.kind == TokenKind.NAME && reader.peek(2).isSign("(")) {
            // A function, whose type is wrong whatever it is.
            reader.readAs(Keyword.INT)
        } else if (token.text in OTHER_TYPES && next.kind == TokenKind.NAME) {
            report(token, Keyword.INT, NqcDiagnosticCode.OTHER_TYPE, sink.messages.otherType(token.text))
        } else {
            val meant = meantBy(token, next) ?: return
            val isCase = token.text.equals(meant.text, ignoreCase = true)
            val message = sink.messages.misspelledWord(token.text, meant.text, isCase)
            report(token, meant, NqcDiagnosticCode.MISSPELLED_WORD, message)
        }
    }

    /** Skips [word], which NQC does not have, before [next]. */
    private fun skipExtraWord(word: Token, next: Token) {
        val isTyped = word.macro == null && next.range.line == word.range.line
        val range = word.range.to(next.range.copy(endColumn = next.range.column))
        val message = sink.messages.extraWord(word.text)
        sink.report(NqcDiagnosticCode.UNEXPECTED_TOKEN, word.range, message, SourceFix(range, "").takeIf { isTyped })
        reader.advance()
        correct()
    }

    /** Reports the token here if it means `else if`; then it can be read like `if`. */
    fun correctElseIf(): Boolean {
        val token = reader.token
        val isElseIf = token.kind == TokenKind.NAME && token.text.lowercase() in ELSE_IFS && reader.peek(1).isSign("(")
        if (!isElseIf || isName(token.text)) return false
        val message = sink.messages.misspelledWord(token.text, ELSE_IF, isCase = false)
        val fix = SourceFix(token.range, ELSE_IF).takeIf { token.macro == null }
        sink.report(NqcDiagnosticCode.MISSPELLED_WORD, token.range, message, fix)
        return true
    }

    private fun report(token: Token, meant: Keyword, code: NqcDiagnosticCode, message: String) {
        sink.report(code, token.range, message, SourceFix(token.range, meant.text).takeIf { token.macro == null })
        reader.readAs(meant)
    }

    private fun meantBy(token: Token, next: Token): Keyword? {
        val keyword = Keyword.of(token.text.lowercase())
        return when {
            keyword != null -> keyword.takeIf { it.group in GROUPS && canFollow(next) }
            next.kind == TokenKind.NAME && reader.peek(2).isSign("(") -> similar(token, UNITS)
            next.isSign("(") && hasBlock() -> similar(token, BLOCKS)
            else -> null
        }
    }

    private fun canFollow(next: Token) =
        next.kind != TokenKind.SIGN || !(next.text in Signs.ASSIGNMENTS || next.text in NO_WORD_BEFORE)

    private fun similar(token: Token, words: Set<Keyword>): Keyword? =
        similarName(token.text, words.map { it.text })?.let { Keyword.of(it) }

    /** Whether a block follows the brackets after this token. */
    private fun hasBlock(): Boolean {
        var depth = 0
        for (distance in 1..LONGEST_CONDITION) {
            val token = reader.peek(distance)
            if (token.isSign("(")) depth++
            if (token.isSign(")") && --depth == 0) return reader.peek(distance + 1).isSign("{")
        }
        return false
    }

    private companion object {
        val GROUPS = setOf(KeywordGroup.UNIT, KeywordGroup.DECLARATION, KeywordGroup.STATEMENT)
        val UNITS = setOf(Keyword.TASK, Keyword.SUB, Keyword.VOID)
        val BLOCKS = setOf(
            Keyword.IF,
            Keyword.WHILE,
            Keyword.REPEAT,
            Keyword.FOR,
            Keyword.SWITCH,
            Keyword.MONITOR,
            Keyword.ACQUIRE,
        )
        val OTHER_TYPES = "float double unsigned long short char byte bool boolean string String var let".split(
            ' ',
        ).toSet()
        val DECLARING = setOf(KeywordGroup.UNIT, KeywordGroup.DECLARATION)

        /** Words that other languages have before a declaration. */
        val EXTRA_WORDS = "static public private final unsigned signed long short volatile extern register global"
            .split(' ').toSet()
        const val ELSE_IF = "else if"
        val ELSE_IFS = setOf("elseif", "elsif", "elif")
        val NO_WORD_BEFORE = setOf("++", "--", "[", ")", ",", ":")

        /** Max tokens of brackets that are looked through. */
        const val LONGEST_CONDITION = 60
    }
}
