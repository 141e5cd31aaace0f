package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.AddressOf
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.FunctionUnit
import robotran.nqc.tree.ParameterKind
import robotran.nqc.tree.Statement
import robotran.nqc.tree.Variable
import robotran.nqc.tree.sourceOf

/** Generates calls of subroutines, and the bodies of functions where they are called. */
internal class CallEmitter(
    private val emitter: Emitter,
    private val statements: StatementEmitter,
    private val units: ProgramUnits,
) {
    private val sink = emitter.sink

    fun call(statement: Statement.Call, frame: FrameLayout) {
        val sub = units.subs[statement.name]
        if (sub != null) return callSub(sub, statement)
        // A name of neither kind is a mistake that the check of calls has reported.
        units.functions[statement.name]?.let { expand(it, statement, frame) }
    }

    private fun callSub(sub: SubCode, statement: Statement.Call) {
        if (!emitter.allocator.areFree(sub.locals)) {
            emitter.outOfVariables()
            val message = sink.messages.noStorageForSub(statement.name)
            emitter.report(NqcDiagnosticCode.NO_STORAGE, statement.range, message)
            throw GenerationStop()
        }
        emitter.add(Opcode.CALLS, sub.number)
    }

    private fun expand(function: FunctionUnit, statement: Statement.Call, frame: FrameLayout) {
        val depth = frame.depth + 1
        if (depth > NqcLimits.CALL_DEPTH) {
            val message = sink.messages.nestedTooDeeply(NqcLimits.CALL_DEPTH)
            emitter.report(NqcDiagnosticCode.NESTED_TOO_DEEPLY, statement.range, message)
            throw GenerationStop()
        }
        val call = frame.call ?: statement.range.takeIf { function.isOfApi }
        val labels = statements.labelsOf(function.body)
        val inner = frame.within(call, depth, labels, units.jumpsOf(function.body).targets)
        val arguments = statement.arguments.map { statements.value(it, frame) }
        if (frame.call == null) checkRanges(function, arguments)
        statements.flow.withinFunction {
            statements.inScope {
                val isBound = function.parameters.zip(arguments).all { (parameter, argument) ->
                    bind(parameter, argument, inner, statement.range)
                }
                if (isBound) statements.emit(function.body, inner)
            }
        }
    }

    /** Gives [parameter] its [argument]; false if that is of a wrong kind. */
    private fun bind(parameter: Variable, argument: Expression, frame: FrameLayout, call: SourceRange): Boolean {
        val messages = sink.messages
        val kind = checkNotNull(parameter.parameter)
        val isRight = when (kind) {
            ParameterKind.VALUE, ParameterKind.EXPRESSION -> true
            ParameterKind.CONSTANT -> argument.constant != null
            ParameterKind.REFERENCE -> argument is Cell
            ParameterKind.SENSOR -> sourceOf(argument)?.type == ValueSource.INPUT.code
            ParameterKind.POINTER, ParameterKind.CONSTANT_POINTER -> isPointer(argument)
        }
        if (!isRight) {
            val (code, message) = when (kind) {
                ParameterKind.CONSTANT -> NqcDiagnosticCode.ARGUMENT_NOT_CONSTANT to messages.argumentNotConstant()
                ParameterKind.REFERENCE -> NqcDiagnosticCode.ARGUMENT_NOT_VARIABLE to messages.argumentNotVariable()
                ParameterKind.SENSOR -> NqcDiagnosticCode.ARGUMENT_NOT_SENSOR to messages.argumentNotSensor()
                else -> NqcDiagnosticCode.ARGUMENT_NOT_POINTER to messages.argumentNotPointer()
            }
            emitter.report(code, argument.range, message)
            return false
        }
        val isCopied = kind == ParameterKind.VALUE || kind == ParameterKind.CONSTANT_POINTER
        frame.bind(parameter, if (isCopied) copied(parameter, argument, call) else argument)
        return true
    }

    private fun isPointer(argument: Expression) = argument is AddressOf || (argument is Cell && argument.isPointer)

    /** A variable of the function with the value of [argument]. */
    private fun copied(parameter: Variable, argument: Expression, call: SourceRange): Expression {
        val place = statements.allocate(1, call)
        statements.name(parameter, place)
        val cell = Cell(place, parameter.isPointer, argument.range)
        statements.assign(cell, argument)
        return cell
    }

    private fun checkRanges(function: FunctionUnit, arguments: List<Expression>) {
        function.limits.zip(arguments).forEach { (limit, argument) ->
            val value = argument.constant
            if (limit != null && value != null && value !in limit.values) {
                val message = sink.messages.argumentRange(limit, value)
                emitter.report(NqcDiagnosticCode.ARGUMENT_RANGE, argument.range, message)
            }
        }
    }
}
