package robotran.robolang

import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts

/** Collects the node types in syntax trees, and finds those that no tree contains. */
internal class FormsOfTrees {
    private val seen = mutableSetOf<Any>()

    fun add(tree: SyntaxTree) {
        tree.statements.forEach(::add)
        tree.routines.forEach { routine -> routine.body.forEach(::add) }
        for (behaviour in tree.behaviours) {
            add(behaviour.condition)
            behaviour.body.forEach(::add)
        }
    }

    fun missing(): List<Any> {
        val sealed = listOf(
            Command::class,
            Statement::class,
            Expression::class,
            Sense::class,
            MotorCommand::class,
            AssignTarget::class,
        )
        val forms: List<Any> = sealed.map { it.java }.flatMap { type ->
            type.declaredClasses.filter { type.isAssignableFrom(it) && !it.isInterface }
        }
        return (forms + BinaryOperator.entries + BuiltIn.entries) - seen
    }

    private fun add(statement: Statement) {
        seen += statement.javaClass
        if (statement is Command.Motor) seen += statement.command.javaClass
        if (statement is Statement.Assign) seen += statement.target.javaClass
        statement.expressions.forEach(::add)
        statement.bodies.forEach { body -> body.forEach(::add) }
    }

    private fun add(expression: Expression) {
        seen += expression.javaClass
        when (expression) {
            is Expression.Sense -> seen += expression.sense.javaClass
            is Expression.Binary -> seen += expression.operator
            is Expression.Call -> BuiltIn.of(expression.name.key)?.let { seen += it }
            else -> Unit
        }
        expression.parts.forEach(::add)
    }
}
