package robotran.nqc.parse

import robotran.legofirmware.image.FirmwareLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.diagnostic.SourceFix
import robotran.nqc.diagnostic.SourceRange
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Token
import robotran.nqc.tree.Expression.VariableUse
import robotran.nqc.tree.Statement.Assignment
import robotran.nqc.tree.Statement.Declaration
import robotran.nqc.tree.Variable

/** Reads what comes after `int`: `a, b = 3, c[5], *p`. */
internal class VariableParser(
    private val reader: TokenReader,
    private val scopes: Scopes,
    private val names: NameResolver,
    private val expressions: ExpressionParser,
) {
    private val sink = reader.sink

    /** Reads variables up to the semicolon, which is left. */
    fun variables(): List<Declaration> {
        val type = reader.previous
        val declarations = mutableListOf<Declaration>()
        do declarations += variable(type) while (reader.accept(","))
        return declarations
    }

    /** @param type the word `int`. */
    private fun variable(type: Token): Declaration {
        val isPointer = reader.isSign("*")
        val sign = if (isPointer) reader.advance() else null
        val name = reader.name()
        if (sign != null) names.requirePointers(sign.range)
        if (scopes.declaresGlobals && reader.isSign("(")) failAtFunction(name, type)
        val size = if (!isPointer && reader.accept("[")) arraySize(name) else null
        val variable = Variable(name.text, name.range, scopes.declaresGlobals, size != null, isPointer, size ?: 1)
        val isFree = scopes.declare(variable)
        names.requireFreeName(isFree, name)
        val initial = if (reader.accept("=")) initial(variable, name.range) else null
        return Declaration(variable, initial, name.range)
    }

    private fun initial(variable: Variable, range: SourceRange): Assignment {
        val value = expressions.expression()
        if (variable.isArray) {
            reader.fail(NqcDiagnosticCode.IS_ARRAY, range, sink.messages.arrayInitialized(variable.name))
        }
        return Assignment(VariableUse(variable, range), value, range)
    }

    private fun arraySize(name: Token): Int {
        names.requireArrays(name.range)
        val size = expressions.expression()
        reader.closing("]")
        val number = expressions.constantOf(size)
        if (size.constant != null && number !in 1..LARGEST_ARRAY) {
            // An array that is only too large for the brick is found when it gets its place.
            sink.report(NqcDiagnosticCode.WRONG_ARRAY_SIZE, size.range, sink.messages.wrongArraySize(LARGEST))
        }
        return number.coerceIn(1, LARGEST_ARRAY)
    }

    private fun failAtFunction(name: Token, type: Token): Nothing = reader.fail(
        NqcDiagnosticCode.FUNCTION_WITH_TYPE,
        name.range,
        sink.messages.functionWithType(name.text),
        SourceFix(type.range, Keyword.VOID.text).takeIf { type.macro == null },
    )

    private companion object {
        const val LARGEST = FirmwareLimits.GLOBAL_VARIABLES
        const val LARGEST_ARRAY = 1000
    }
}
