package robotran.nqc.preprocess

import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.API_RANGE
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.syntax.Lexer
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/**
 * The tokens of a program's files and of its macros, before anything is replaced.
 *
 * @param isActive whether what is read now belongs to the program.
 */
internal class TokenSource(
    private val files: Map<String, String>,
    private val sink: DiagnosticSink,
    private val isActive: () -> Boolean,
) {
    private val lexers = mutableListOf<Lexer>()

    /** Tokens that come before those of the files. */
    private val pending = ArrayDeque<Token>()
    private var opened = 0
    private var replaced = 0
    private var last: Token? = null

    /** Whether macros put in, or wanted to put in, more than [NqcLimits.REPLACED_TOKENS] tokens. */
    var isExhausted = false
        private set

    fun has(file: String): Boolean = file in files

    /** Goes on with the tokens of [file], which must exist; false if there are too many files. */
    fun open(file: String): Boolean {
        if (lexers.size >= NqcLimits.INCLUDE_DEPTH || opened >= NqcLimits.INCLUDED_FILES) return false
        opened++
        lexers += Lexer(file, files.getValue(file), sink, isActive)
        return true
    }

    /** Whether macros may put in [count] more tokens. */
    fun allows(count: Long): Boolean {
        if (replaced + count > NqcLimits.REPLACED_TOKENS) isExhausted = true
        return !isExhausted
    }

    /** Goes on with [tokens]. */
    fun put(tokens: List<Token>) {
        if (!allows(tokens.size + 1L)) return
        replaced += tokens.size + 1
        for (index in tokens.indices.reversed()) pending.addFirst(tokens[index])
    }

    /** The next token; after the last file always one of kind [TokenKind.END]. */
    fun next(): Token {
        pending.removeFirstOrNull()?.let { return it }
        while (true) {
            val lexer = lexers.lastOrNull() ?: return last ?: Token(TokenKind.END, "", API_RANGE)
            val token = lexer.next()
            if (token.kind != TokenKind.END) return token
            lexers.removeAt(lexers.lastIndex)
            last = token
        }
    }
}
