package robotran.robolang.python

import robotran.brick.kind.BrickKind
import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens

/** What is asked about Python that is shown and not edited: its colours. */
object PythonSyntax : CodeSyntax {
    override val indent = "    "
    override val commentMark = "#"
    override val blockEnds = emptySet<String>()
    override val keys = emptyList<String>()
    override val hasFormat = false

    override fun blockEffect(line: String) = BlockEffect(closes = false, opens = line.trimEnd().endsWith(':'))

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens {
        val tokens = TOKEN.findAll(line).map { CodeToken(kindOf(it.value), it.range.first, it.range.last + 1) }
        return LineTokens(tokens.toList(), endsInComment = false)
    }

    private fun kindOf(text: String): CodeTokenKind = when {
        text.startsWith('#') -> CodeTokenKind.COMMENT
        text.startsWith('"') -> CodeTokenKind.TEXT
        text.first().isDigit() -> CodeTokenKind.NUMBER
        text in KEYWORDS -> CodeTokenKind.KEYWORD
        text in BUILT_INS || text.first() in 'A'..'Z' -> CodeTokenKind.BUILT_IN
        text.first().isLetter() || text.first() == '_' -> CodeTokenKind.NAME
        else -> CodeTokenKind.SIGN
    }

    override fun complete(request: CompletionRequest): CompletionList? = null

    override fun format(source: String): String? = null

    private val TOKEN by lazy { Regex("#.*|\"(?:[^\"\\\\]|\\\\.)*\"?|[\\p{L}_][\\p{L}\\p{N}_]*|\\d[\\w.]*|[^\\s\\w]") }
    private val KEYWORDS by lazy {
        setOf(
            "and",
            "as",
            "async",
            "await",
            "break",
            "class",
            "continue",
            "def",
            "elif",
            "else",
            "except",
            "False",
            "finally",
            "for",
            "from",
            "global",
            "if",
            "import",
            "in",
            "is",
            "not",
            "or",
            "pass",
            "raise",
            "return",
            "True",
            "try",
            "while",
        )
    }
    private val BUILT_INS by lazy { setOf("abs", "float", "int", "len", "max", "min", "print", "range", "round") }
}
