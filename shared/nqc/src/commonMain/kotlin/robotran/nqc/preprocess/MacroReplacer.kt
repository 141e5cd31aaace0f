package robotran.nqc.preprocess

import robotran.language.source.SourceRange
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.MacroUse
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** Reads tokens with all macros replaced. */
internal class MacroReplacer(
    private val source: TokenSource,
    private val macros: Map<String, Macro>,
    private val sink: DiagnosticSink,
) {
    /**
     * The next token that is no macro.
     *
     * @param isActive false where macros stay as they are.
     */
    fun next(isActive: Boolean): Token {
        while (true) {
            val token = source.next()
            val macro = if (isActive && token.kind == TokenKind.NAME) macros[token.text] else null
            if (macro == null) return token
            val replaced = replace(token, macro)
            if (source.isExhausted) {
                sink.report(NqcDiagnosticCode.MACROS_TOO_LONG, token.range, sink.messages.macrosTooLong(macro.name))
                return token.copy(kind = TokenKind.END, text = "")
            }
            if (!replaced) return token.copy(kind = TokenKind.NUMBER, text = "0")
        }
    }

    /** Puts in what [macro] stands for; false if it is used wrongly. */
    private fun replace(token: Token, macro: Macro): Boolean {
        val use = token.macro
        if (use != null && (use.isWithin(macro.name) || use.depth >= NqcLimits.MACRO_DEPTH)) {
            sink.report(NqcDiagnosticCode.MACRO_CIRCULAR, token.range, sink.messages.macroCircular(macro.name))
            return false
        }
        val parameters = macro.parameters
        var end: SourceRange? = null
        val arguments = if (parameters == null) emptyList() else argumentsOf(parameters.size) { end = it.range }
        if (arguments == null) {
            val count = parameters.orEmpty().size
            sink.report(NqcDiagnosticCode.MACRO_ARGUMENTS, token.range, sink.messages.macroArguments(macro.name, count))
            return false
        }
        val own = MacroUse(macro.name, use, end ?: token.range)
        val places = macro.body.map { if (it.kind == TokenKind.NAME) parameters.orEmpty().indexOf(it.text) else -1 }
        if (!source.allows(places.sumOf { if (it >= 0) arguments[it].size.toLong() else 1L })) return false
        source.put(
            macro.body.flatMapIndexed { index, part ->
                val place = places[index]
                if (place >= 0) arguments[place] else listOf(placed(part, token.range, own))
            },
        )
        return true
    }

    private fun placed(part: Token, range: SourceRange, use: MacroUse) =
        part.copy(range = range, macro = use, definedAt = part.definedAt ?: part.range)

    /** Reads `(..)` with [count] arguments, and gives its last bracket to [close]; null if there are more or fewer. */
    private fun argumentsOf(count: Int, close: (Token) -> Unit): List<List<Token>>? {
        val first = source.next()
        if (!first.isSign("(")) {
            source.put(listOf(first))
            return null
        }
        val arguments = mutableListOf<List<Token>>()
        var argument = mutableListOf<Token>()
        var nesting = 0
        while (true) {
            val token = source.next()
            if (token.kind == TokenKind.END || token.kind == TokenKind.END_OF_DIRECTIVE) {
                source.put(listOf(token))
                return null
            }
            when {
                token.isSign("(") -> nesting++
                token.isSign(")") -> nesting--
            }
            val isEnd = nesting < 0
            if (!isEnd && !(nesting == 0 && token.isSign(","))) {
                argument += token
                continue
            }
            arguments += argument
            argument = mutableListOf()
            if (isEnd) {
                close(token)
                break
            }
        }
        val isEmpty = count == 0 && arguments.size == 1 && arguments.single().isEmpty()
        return if (isEmpty) emptyList() else arguments.takeIf { it.size == count }
    }
}
