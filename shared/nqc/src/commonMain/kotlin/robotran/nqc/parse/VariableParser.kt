package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
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

    /** Reads `int a, b = 3` up to the semicolon, which is left; also with a `const`, which is a mistake. */
    fun declarations(): List<Declaration> {
        if (reader.isKeyword(Keyword.CONST) || reader.peek(1).keyword == Keyword.CONST) skipConstant()
        reader.accept(Keyword.INT)
        return variables(reader.previous)
    }

    /** Skips `const int` or `int const`, and reports it. */
    private fun skipConstant() {
        val first = reader.token
        val define = definitionHere()
        while (reader.isKeyword(Keyword.CONST) || reader.isKeyword(Keyword.INT)) reader.advance()
        val range = first.range.to(reader.previous.range)
        val right = define?.replacement ?: "${Keyword.INT.text} ${reader.token.text}"
        val isTyped = first.macro == null && reader.previous.macro == null && reader.isInLineOf(first)
        val fix = define ?: SourceFix(range, Keyword.INT.text).takeIf { isTyped }
        sink.report(NqcDiagnosticCode.UNEXPECTED_TOKEN, range, sink.messages.constantVariable(right), fix)
    }

    /** What makes a `#define` of the constant here; null unless a single one is declared and alone in its line. */
    private fun definitionHere(): SourceFix? {
        val first = reader.token
        if (reader.index > 0 && reader.isInLineOf(reader.previous)) return null
        val line = (0..LONGEST_CONSTANT).map(reader::peek).distinct().takeWhile {
            it.kind != TokenKind.END && it.range.line == first.range.line
        }
        val declared = line.dropWhile { it.keyword != null }
        val value = declared.drop(2).dropLast(1)
        val isConstant = declared.size > 2 && declared[0].kind == TokenKind.NAME && declared[1].isSign("=") &&
            line.last().isSign(";") && value.none { it.isSign(";") || it.isSign(",") } && line.all { it.macro == null }
        if (!isConstant || value.isEmpty()) return null
        val written = reader.textAt(value.first().range.to(value.last().range)) ?: return null
        val number = if (value.size > 1) "($written)" else written
        return SourceFix(first.range.to(line.last().range), "#define ${declared[0].text} $number")
    }

    private fun variables(type: Token): List<Declaration> {
        val declarations = mutableListOf<Declaration>()
        do declarations += variable(type) while (reader.accept(","))
        return declarations
    }

    /** @param type the word `int`. */
    private fun variable(type: Token): Declaration {
        val isPointer = reader.accept("*")
        val name = reader.name()
        if (scopes.declaresGlobals && reader.isSign("(")) failAtFunction(name, type)
        val size = if (!isPointer && reader.accept("[")) arraySize(name) else null
        val variable = Variable(name.text, name.range, scopes.declaresGlobals, size != null, isPointer, size ?: 1)
        val isFree = scopes.declare(variable)
        names.requireFreeName(isFree, name)
        val initial = if (reader.accept("=")) initial(variable, name.range) else null
        return Declaration(variable, initial, name.range)
    }

    private fun initial(variable: Variable, range: SourceRange): Assignment {
        if (variable.isPointer) names.requirePointers(range)
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
        /** Max tokens of a constant that a fix makes a `#define` of. */
        const val LONGEST_CONSTANT = 30
        const val LARGEST = FirmwareLimits.GLOBAL_VARIABLES
        const val LARGEST_ARRAY = 1000
    }
}
