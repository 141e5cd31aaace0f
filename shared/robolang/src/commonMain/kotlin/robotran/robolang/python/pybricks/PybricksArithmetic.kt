package robotran.robolang.python.pybricks

import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonArithmetic
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.primary
import robotran.robolang.robot.HubFigures
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement

/** A hub counts as Python does; only what would come out as another number is a function. */
internal class PybricksArithmetic(private val context: PythonContext) : PythonArithmetic {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }
    private val program = context.program
    private val uses = context.uses
    private val notes = context.notes

    override fun checked(number: Long, expression: Expression): String {
        if (number > HubFigures.LARGEST || number < -HubFigures.LARGEST - 1) {
            notes.lost(expression.range, notes.messages.numberTooLarge("$number"))
        }
        return "$number"
    }

    override fun quotient(expression: Expression.Binary): PythonText {
        if (program.typeOf(expression) == ValueType.DECIMAL) {
            return expressions.joined(expression, "/", PythonStrength.PRODUCT)
        }
        notes.tell(expression.range, notes.messages.wholeDivision())
        if (!needsHelper(expression)) return expressions.joined(expression, "//", PythonStrength.PRODUCT)
        return primary("${uses.use(PybricksHelper.DIVIDE)}(${sides(expression)})")
    }

    override fun remainder(expression: Expression.Binary): PythonText {
        val isWhole = program.typeOf(expression) == ValueType.WHOLE
        if (isWhole && !needsHelper(expression)) return expressions.joined(expression, "%", PythonStrength.PRODUCT)
        val helper = if (isWhole) PybricksHelper.REMAINDER else PybricksHelper.DECIMAL_REMAINDER
        return primary("${uses.use(helper)}(${sides(expression)})")
    }

    private fun sides(expression: Expression.Binary): String =
        expressions.arguments(listOf(expression.left, expression.right))

    /** Whether [expression], a division or a remainder, is not as Python's own. */
    fun needsHelper(expression: Expression.Binary): Boolean {
        val isDivision = expression.operator == BinaryOperator.DIVIDE || expression.operator == BinaryOperator.MOD
        return isDivision && !(expressions.isNeverBelow(expression.left) && expressions.isNeverBelow(expression.right))
    }

    override fun element(expression: Expression.ListElement): PythonText =
        primary("${expressions.text(expression.list, PythonStrength.PRIMARY)}[${index(expression.index)}]")

    override fun setElement(list: Name, index: Expression, value: String): String =
        "${context.names.of(program.symbolOf(list))}[${index(index)}] = $value"

    private fun index(index: Expression): String {
        if (!expressions.isNeverBelow(index)) notes.tell(index.range, notes.messages.negativeIndex())
        return expressions.text(index)
    }

    override fun random(call: Expression.Call): PythonText {
        val (first, second) = call.arguments
        val from = whole(first)
        val to = whole(second)
        if (from != null && to != null) {
            return primary("${uses.import("urandom", "randint")}(${minOf(from, to)}, ${maxOf(from, to)})")
        }
        return primary("${uses.use(PybricksHelper.RANDOM)}(${expressions.arguments(call.arguments)})")
    }

    private fun whole(expression: Expression): Int? = (expressions.literal(expression) as? NumberValue.Whole)?.value

    override fun rootOrPower(builtIn: BuiltIn, call: Expression.Call, arguments: String): PythonText =
        primary("${uses.import("umath", builtIn.text)}($arguments)")

    override fun times(loop: Statement.Repeat): String = "range(${expressions.text(loop.count)})"

    override fun count(loop: Statement.ForRange, arguments: String): String =
        "${uses.use(PybricksHelper.COUNT)}($arguments)"
}
