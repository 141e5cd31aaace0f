package robotran.nqc.preprocess

import robotran.language.source.SourceRange
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** Reads `#pragma noinit`, `#pragma init NAME` and `#pragma reserve FIRST LAST`. */
internal class PragmaReader(private val sink: DiagnosticSink) {
    private var hasInit = true
    private var init: InitFunction? = null
    private val reserved = mutableListOf<Pair<IntRange, SourceRange>>()

    fun result() = Pragmas(hasInit, init, reserved.toList())

    /** @param line what comes after the [directive] in its line. */
    fun read(directive: Token, line: List<Token>) {
        val isKnown = when (line.firstOrNull()?.text) {
            "noinit" -> true.also { hasInit = false }
            "init" -> readInit(line.getOrNull(1))
            "reserve" -> readReserve(line)
            else -> false
        }
        if (isKnown) return
        val word = line.firstOrNull()
        val range = word?.range ?: directive.range
        sink.report(NqcDiagnosticCode.UNKNOWN_PRAGMA, range, sink.messages.unknownPragma(word?.text.orEmpty()))
    }

    private fun readInit(name: Token?): Boolean {
        if (name?.kind != TokenKind.NAME) return false
        hasInit = true
        init = InitFunction(name.text, name.range)
        return true
    }

    private fun readReserve(line: List<Token>): Boolean {
        val numbers = line.drop(1)
        if (numbers.size !in 1..2 || numbers.any { it.kind != TokenKind.NUMBER }) return false
        val range = numbers.first().range.to(numbers.last().range)
        reserved += numbers.first().value..numbers.last().value to range
        return true
    }
}
