package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement

/** Writes globals as fields; those with a constant initial value are initialised there. */
internal class JavaFields(
    private val program: CheckedProgram,
    private val names: JavaNames,
    private val expressions: JavaExpressions,
    private val comments: CommentsOfItems,
) {
    private val statements = program.tree.statements
    private val globals = statements.filterIsInstance<Statement.Declare>().filter { program.symbolOf(it.name).isGlobal }
    private val settled = mutableSetOf<Symbol>()
    private val fields: Set<Statement>

    init {
        val first = statements.takeWhile { it is Statement.Declare }
        fields =
            globals.filter {
                (it.isConstant || it in first) && isPlain(it.value) &&
                    settled.add(program.symbolOf(it.name))
            }.toSet()
    }

    /** Whether [statement] declares an initialised field, so that `main` need not assign it. */
    fun isField(statement: Statement): Boolean = statement in fields

    fun write(writer: JavaWriter) {
        writer.blank()
        for (declaration in globals) {
            val symbol = program.symbolOf(declaration.name)
            val field =
                "static ${if (isFinal(declaration)) "final " else ""}${javaType(symbol.type)} ${names.of(symbol)}"
            if (isField(declaration)) {
                writer.takeComments(comments.of(declaration.range))
                writer.line("$field = ${initial(declaration.value)};", declaration.range.line, names.noteOn(symbol))
            } else {
                writer.line("$field;", LineMap.NO_LINE, names.noteOn(symbol))
            }
        }
    }

    private fun isFinal(declaration: Statement.Declare) = declaration.isConstant && isField(declaration)

    private fun initial(value: Expression): String =
        if (value is Expression.ListOf) expressions.elements(value) else expressions.text(value)

    /** Whether [value] is constant and evaluating it cannot fail. */
    private fun isPlain(value: Expression): Boolean = when (value) {
        is Expression.Number, is Expression.BooleanLiteral, is Expression.ColourLiteral -> true
        is Expression.ListOf -> value.elements.all(::isPlain)
        is Expression.Variable -> program.symbolOf(value.name).let { it in settled && !it.type.isList }
        is Expression.Unary -> isPlain(value.operand)
        is Expression.Binary -> value.operator !in FALLIBLE && isPlain(value.left) && isPlain(value.right)
        is Expression.Brackets -> isPlain(value.inner)
        is Expression.ListElement, is Expression.Call, is Expression.Sense -> false
    }

    private companion object {
        val FALLIBLE = setOf(BinaryOperator.DIVIDE, BinaryOperator.MOD)
    }
}
