package robotran.nqc.parse

import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.AssemblyField
import robotran.nqc.tree.Statement

/** Reads `asm { bytes };`. */
internal class AssemblyParser(private val reader: TokenReader, private val expressions: ExpressionParser) {
    private val sink = reader.sink

    fun assembly(): Statement {
        val word = reader.advance()
        reader.opening("{")
        val fields = mutableListOf<AssemblyField>()
        if (!reader.isSign("}")) {
            do fields += field() while (reader.accept(","))
        }
        reader.closing("}")
        reader.semicolon()
        return Statement.Assembly(fields, word.range)
    }

    private fun field(): AssemblyField {
        if (!reader.accept("$")) {
            val byte = expressions.expression()
            if (!byte.isPromisedConstant) {
                sink.report(NqcDiagnosticCode.CONSTANT_NEEDED, byte.range, sink.messages.constantNeeded())
            }
            return AssemblyField.Byte(byte)
        }
        val value = expressions.expression()
        return AssemblyField.Operand(value, if (reader.accept(":")) expressions.constant() else 0)
    }
}
