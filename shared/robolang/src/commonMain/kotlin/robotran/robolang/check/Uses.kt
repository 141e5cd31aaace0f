package robotran.robolang.check

import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts

/** The names of the variables and routines that a part of a program uses, including built-in ones. */
internal class Uses {
    val variables = mutableListOf<Name>()
    val calls = mutableListOf<Name>()

    fun add(statements: List<Statement>) = statements.forEach(::add)

    fun add(statement: Statement) {
        statement.expressions.forEach(::add)
        when (statement) {
            is Statement.Call -> calls += statement.name
            is Statement.Assign -> variables += statement.target.variable
            else -> Unit
        }
        statement.bodies.forEach(::add)
    }

    fun add(expression: Expression) {
        expression.parts.forEach(::add)
        when (expression) {
            is Expression.Variable -> variables += expression.name
            is Expression.Call -> calls += expression.name
            else -> Unit
        }
    }

    private val AssignTarget.variable: Name
        get() = when (this) {
            is AssignTarget.Variable -> name
            is AssignTarget.ListElement -> list
        }
}
