package robotran.nqc.preprocess

import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** Follows `#define` and `#undef`. */
internal class MacroDefinitions(private val macros: MutableMap<String, Macro>, private val sink: DiagnosticSink) {
    /** @param line what comes after the [directive] in its line. */
    fun define(directive: Token, line: List<Token>) {
        val name = nameIn(directive, line) ?: return
        if (name.text in macros) {
            sink.report(NqcDiagnosticCode.MACRO_REDEFINED, name.range, sink.messages.macroRedefined(name.text))
            return
        }
        val next = line.getOrNull(1)
        if (next == null || next.isSeparate) {
            macros[name.text] = Macro(name.text, null, line.drop(1))
            return
        }
        val end = line.indexOfFirst { it.isSign(")") }
        val parameters = if (next.isSign("(") && end > 0) parametersIn(line.subList(2, end)) else null
        if (parameters == null) {
            sink.report(NqcDiagnosticCode.MACRO_PARAMETERS, next.range, sink.messages.macroParameters(name.text))
        } else {
            macros[name.text] = Macro(name.text, parameters, line.drop(end + 1))
        }
    }

    fun undefine(directive: Token, line: List<Token>) {
        nameIn(directive, line)?.let { macros.remove(it.text) }
    }

    private fun nameIn(directive: Token, line: List<Token>): Token? {
        val name = line.firstOrNull()?.takeIf { it.kind == TokenKind.NAME }
        if (name == null) {
            sink.report(
                NqcDiagnosticCode.DIRECTIVE_NEEDS_NAME,
                line.firstOrNull()?.range ?: directive.range.end,
                sink.messages.directiveNeedsName(directive.text),
            )
        }
        return name
    }

    /** The names in `A, B`; null if there is anything else, or a name twice. */
    private fun parametersIn(list: List<Token>): List<String>? {
        if (list.isEmpty()) return emptyList()
        val names = list.filterIndexed { index, _ -> index % 2 == 0 }
        val commas = list.filterIndexed { index, _ -> index % 2 == 1 }
        val isList = names.size in 1..NqcLimits.MACRO_PARAMETERS && names.size == commas.size + 1 &&
            names.all { it.kind == TokenKind.NAME } && commas.all { it.isSign(",") }
        return names.map { it.text }.takeIf { isList && it.distinct().size == it.size }
    }
}
