package robotran.nqc.tree

import robotran.language.source.SourceRange
import robotran.nqc.syntax.Token

/** A statement. */
internal sealed class Statement {
    /** What a debugger marks: the first line of the statement. */
    abstract val range: SourceRange

    /** The statements in it, in the order of the source. */
    open val parts: List<Statement> get() = emptyList()

    /** The expressions in it, without those in [parts]. */
    open val expressions: List<Expression> get() = emptyList()

    /** @property isScope whether variables that it declares end with it. */
    class Block(val statements: List<Statement>, val isScope: Boolean, override val range: SourceRange) : Statement() {
        override val parts get() = statements
    }

    /** One variable, with the assignment of its initial value. */
    class Declaration(val variable: Variable, val initial: Assignment?, override val range: SourceRange) : Statement() {
        override val parts get() = listOfNotNull(initial)
    }

    class Assignment(val target: Expression, val value: Expression, override val range: SourceRange) : Statement() {
        override val expressions get() = listOf(target, value)
    }

    /** `v += e` for a plain variable [target]: one instruction. */
    class Update(
        val target: Expression,
        val operation: VariableOperation,
        val value: Expression,
        override val range: SourceRange,
    ) : Statement() {
        override val expressions get() = listOf(target, value)
    }

    class Evaluation(val value: Expression, override val range: SourceRange) : Statement() {
        override val expressions get() = listOf(value)
    }

    /** @property end the closing bracket. */
    class Call(
        val name: String,
        val arguments: List<Expression>,
        override val range: SourceRange,
        val end: SourceRange,
        val macro: Boolean,
    ) : Statement() {
        override val expressions get() = arguments
    }

    class If(
        val condition: Expression,
        val then: Statement,
        val otherwise: Statement?,
        override val range: SourceRange,
    ) : Statement() {
        override val parts get() = listOfNotNull(then, otherwise)
        override val expressions get() = listOf(condition)
    }

    class While(val condition: Expression, val body: Statement, override val range: SourceRange) : Statement() {
        override val parts get() = listOf(body)
        override val expressions get() = listOf(condition)
    }

    class DoWhile(val body: Statement, val condition: Expression, override val range: SourceRange) : Statement() {
        override val parts get() = listOf(body)
        override val expressions get() = listOf(condition)
    }

    class For(
        val first: Statement?,
        val condition: Expression?,
        val step: Statement?,
        val body: Statement,
        override val range: SourceRange,
    ) : Statement() {
        override val parts get() = listOfNotNull(first, step, body)
        override val expressions get() = listOfNotNull(condition)
    }

    class Repeat(val count: Expression, val body: Statement, override val range: SourceRange) : Statement() {
        override val parts get() = listOf(body)
        override val expressions get() = listOf(count)
    }

    class Switch(val selector: Expression, val body: Statement, override val range: SourceRange) : Statement() {
        override val parts get() = listOf(body)
        override val expressions get() = listOf(selector)
    }

    /** @property value null for `default`. */
    class Case(val value: Int?, val body: Statement, override val range: SourceRange) : Statement() {
        override val parts get() = listOf(body)
    }

    class Label(val name: String, val body: Statement, override val range: SourceRange) : Statement() {
        override val parts get() = listOf(body)
    }

    class Goto(val label: String, override val range: SourceRange) : Statement()

    /** `break;`, `continue;` or `return;` */
    class Leave(val kind: LeaveKind, override val range: SourceRange) : Statement()

    /** `start task;` or `stop task;` */
    class TaskCommand(val task: String, val isStart: Boolean, override val range: SourceRange, val name: Token) :
        Statement()

    class Monitor(
        val events: Expression,
        val body: Statement,
        val handlers: List<Handler>,
        override val range: SourceRange,
    ) : Statement() {
        override val parts get() = listOf(body) + handlers.map { it.body }
        override val expressions get() = listOf(events)
    }

    class Acquire(val resources: Int, val body: Statement, val handler: Statement?, override val range: SourceRange) :
        Statement() {
        override val parts get() = listOfNotNull(body, handler)
    }

    class Assembly(val fields: List<AssemblyField>, override val range: SourceRange) : Statement() {
        override val expressions get() = fields.map { it.value }
    }
}

/** @property mask the events of `catch (mask)`; null for a `catch` of all. */
internal class Handler(val mask: Int?, val body: Statement, val range: SourceRange)

internal enum class LeaveKind(val word: String) { CONTINUE("continue"), BREAK("break"), RETURN("return") }

/** Instructions that change a variable by a value. */
internal enum class VariableOperation { SET, ADD, SUBTRACT, DIVIDE, MULTIPLY, SIGN, ABSOLUTE, AND, OR }
