package robotran.nqc.parse

import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.tree.ParameterKind
import robotran.nqc.tree.Variable

/** Reads the parameters of functions. */
internal class ParameterParser(
    private val reader: TokenReader,
    private val scopes: Scopes,
    private val names: NameResolver,
) {
    /** Reads `const int &a, int b`, `void` or nothing, up to the closing bracket, which is left. */
    fun parameters(): List<Variable> {
        if (reader.isSign(")") || (reader.isKeyword(Keyword.VOID) && reader.peek(1).isSign(")"))) {
            reader.accept(Keyword.VOID)
            return emptyList()
        }
        val parameters = mutableListOf<Variable>()
        do parameters += parameter() while (reader.accept(","))
        return parameters
    }

    private fun parameter(): Variable {
        val start = reader.token
        val kind = kind()
        val name = reader.name()
        val isPointer = kind == ParameterKind.POINTER || kind == ParameterKind.CONSTANT_POINTER
        if (isPointer) names.requirePointers(start.range.to(name.range))
        val variable = Variable(name.text, name.range, isPointer = isPointer, parameter = kind)
        val isFree = scopes.declare(variable)
        names.requireFreeName(isFree, name)
        return variable
    }

    private fun kind(): ParameterKind {
        if (reader.accept(Keyword.SENSOR)) return ParameterKind.SENSOR
        val isConstant = reader.accept(Keyword.CONST)
        if (!reader.accept(Keyword.INT)) {
            val message = reader.sink.messages.parameterNeedsType(reader.token.text)
            reader.fail(NqcDiagnosticCode.UNEXPECTED_TOKEN, reader.token.range, message)
        }
        return when {
            reader.accept("&") -> if (isConstant) ParameterKind.EXPRESSION else ParameterKind.REFERENCE
            reader.accept("*") -> if (isConstant) ParameterKind.CONSTANT_POINTER else ParameterKind.POINTER
            else -> if (isConstant) ParameterKind.CONSTANT else ParameterKind.VALUE
        }
    }
}
