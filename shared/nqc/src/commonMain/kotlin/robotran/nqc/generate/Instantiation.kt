package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.BinaryOperator
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.AddressOf
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.Expression.Choice
import robotran.nqc.tree.Expression.Constant
import robotran.nqc.tree.Expression.Element
import robotran.nqc.tree.Expression.IndexedSource
import robotran.nqc.tree.Expression.PointedAt
import robotran.nqc.tree.Expression.Query
import robotran.nqc.tree.Expression.Source
import robotran.nqc.tree.Expression.Step
import robotran.nqc.tree.Expression.TaskNumber
import robotran.nqc.tree.Expression.Unary
import robotran.nqc.tree.Expression.VariableUse
import robotran.nqc.tree.Variable
import robotran.nqc.tree.isDivision

/** Replaces variables and parameters of a frame by their places and arguments. */
internal class Instantiation(private val emitter: Emitter, private val frame: FrameLayout) {
    private val sink = emitter.sink

    fun of(expression: Expression): Expression {
        val result = replaced(expression)
        if (result.weight >= Expression.HEAVY) emitter.tooLong()
        if (result.height > NqcLimits.EXPANDED_HEIGHT) {
            val message = sink.messages.nestedTooDeeply(NqcLimits.EXPANDED_HEIGHT)
            emitter.report(NqcDiagnosticCode.NESTED_TOO_DEEPLY, result.range, message)
            throw GenerationStop()
        }
        checkDivisions(result)
        if (frame.call == null) emitter.sensors.note(result)
        return result
    }

    private fun replaced(expression: Expression): Expression {
        emitter.work(1)
        return when (expression) {
            is Constant -> expression.copy(range = at(expression.range))
            is VariableUse -> use(expression)
            is Element -> expression.copy(index = replaced(expression.index), place = placeOf(expression.variable))
            is AddressOf -> addressOf(expression)
            is PointedAt -> pointedAt(expression)
            is Unary -> expression.copy(operand = replaced(expression.operand), range = at(expression.range))
            is Binary -> binary(expression)
            is Choice -> choice(expression)
            is Step -> expression.copy(target = replaced(expression.target))
            is Source -> Source(replaced(expression.source), at(expression.range))
            is IndexedSource -> indexedSource(expression)
            is Query -> expression.copy(operand = replaced(expression.operand), range = at(expression.range))
            is TaskNumber -> taskNumber(expression)
            is Cell -> expression
        }
    }

    /** What is in the API is told at its call. */
    private fun at(range: SourceRange): SourceRange = frame.call ?: range

    private fun use(expression: VariableUse): Expression {
        val binding = frame.binding(expression.variable) ?: return Constant(0, at(expression.range))
        return if (binding is Cell) binding.copy(range = at(expression.range)) else binding
    }

    private fun placeOf(variable: Variable): Int = (frame.binding(variable) as? Cell)?.place ?: 0

    private fun addressOf(expression: AddressOf): Expression {
        val binding = frame.binding(expression.variable)
        return if (binding == null ||
            binding is Cell
        ) {
            expression.copy(place = placeOf(expression.variable))
        } else {
            binding
        }
    }

    /** A pointer that is constant is the variable itself. */
    private fun pointedAt(expression: PointedAt): Expression {
        val binding = frame.binding(expression.variable)
        val address = binding?.constant
        return when {
            binding is Cell -> expression.copy(place = binding.place)
            address != null -> Cell(address, isPointer = false, at(expression.range))
            else -> expression.copy(place = 0)
        }
    }

    private fun binary(expression: Binary) = expression.copy(
        left = replaced(expression.left),
        right = replaced(expression.right),
        range = at(expression.range),
    )

    private fun choice(expression: Choice) = Choice(
        replaced(expression.condition),
        replaced(expression.then),
        replaced(expression.otherwise),
        at(expression.range),
    )

    private fun indexedSource(expression: IndexedSource) =
        IndexedSource(replaced(expression.sources), replaced(expression.index), at(expression.range))

    private fun taskNumber(expression: TaskNumber): Expression {
        if (frame.task == null) {
            emitter.report(NqcDiagnosticCode.TASK_NUMBER_UNKNOWN, expression.range, sink.messages.taskNumberUnknown())
        }
        return expression.copy(task = frame.task ?: 0)
    }

    private fun checkDivisions(expression: Expression) {
        if (expression is Binary && expression.isDivision && expression.right.constant == 0) {
            val isConstant = expression.left.constant != null
            val code =
                if (isConstant) NqcDiagnosticCode.CONSTANT_DIVIDED_BY_ZERO else NqcDiagnosticCode.DIVIDED_BY_ZERO
            val isModulo = expression.operator == BinaryOperator.MODULO
            emitter.report(code, expression.range, sink.messages.dividedByZero(isConstant, isModulo))
        }
        expression.parts.forEach { checkDivisions(it) }
    }
}
