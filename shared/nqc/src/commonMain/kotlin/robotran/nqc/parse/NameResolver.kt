package robotran.nqc.parse

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.diagnostic.SourceFix
import robotran.nqc.diagnostic.SourceRange
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.similarName
import robotran.nqc.tree.Variable

/**
 * Finds what names mean, and explains those that mean nothing.
 *
 * @param words all other names that a value can begin with.
 * @param isFunction whether there is a task, subroutine or function of a name so far.
 * @param needsSecondFirmware whether the API has a name for another firmware only.
 */
internal class NameResolver(
    private val reader: TokenReader,
    private val scopes: Scopes,
    private val target: FirmwareTarget,
    private val words: Set<String>,
    private val isFunction: (String) -> Boolean,
    private val needsSecondFirmware: (String) -> Boolean,
) {
    private val sink = reader.sink
    private val unknown = Variable("", SourceRange.API)

    /** The variable [name]; one that stands for it after a mistake. */
    fun variable(name: Token): Variable {
        scopes.variable(name.text)?.let { return it }
        val text = name.text
        if (needsSecondFirmware(text)) {
            val message = sink.messages.needsSecondFirmware(text)
            sink.report(NqcDiagnosticCode.UNDEFINED_VARIABLE, name.range, message)
            return unknown
        }
        val similar = similarName(text, scopes.variableNames + words)
        sink.report(
            NqcDiagnosticCode.UNDEFINED_VARIABLE,
            name.range,
            sink.messages.undefinedVariable(text, similar),
            similar?.takeIf { name.macro == null }?.let { SourceFix(name.range, it) },
        )
        return unknown
    }

    fun isUnknown(variable: Variable): Boolean = variable === unknown

    /** Fails because a call with this [name] is used like a value. */
    fun failAtCallAsValue(name: Token): Nothing {
        val text = name.text
        when {
            isFunction(text) -> {
                reader.fail(NqcDiagnosticCode.CALL_AS_VALUE, name.range, sink.messages.callAsValue(text))
            }

            needsSecondFirmware(text) -> {
                val message = sink.messages.needsSecondFirmware(text)
                reader.fail(NqcDiagnosticCode.UNDEFINED_FUNCTION, name.range, message)
            }

            else -> {
                val similar = similarName(text, words)
                reader.fail(
                    NqcDiagnosticCode.UNDEFINED_FUNCTION,
                    name.range,
                    sink.messages.undefinedFunction(text, similar),
                    similar?.takeIf { name.macro == null }?.let { SourceFix(name.range, it) },
                )
            }
        }
    }

    /** Reports a pointer or an array for a firmware that has none. */
    fun requirePointers(range: SourceRange) {
        if (target == FirmwareTarget.RCX) {
            sink.report(NqcDiagnosticCode.POINTER_UNSUPPORTED, range, sink.messages.pointerUnsupported())
        }
    }

    fun requireArrays(range: SourceRange) {
        if (target == FirmwareTarget.RCX) {
            sink.report(NqcDiagnosticCode.ARRAY_UNSUPPORTED, range, sink.messages.arrayUnsupported())
        }
    }

    fun requireFreeName(isFree: Boolean, name: Token) {
        if (isFree) return
        val message = sink.messages.redeclared(name.text, scopes.lineOf(name.text))
        sink.report(NqcDiagnosticCode.REDECLARED, name.range, message)
    }
}
