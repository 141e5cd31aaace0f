package robotran.robolang.translate

import robotran.robolang.run.RobotConstants
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts

/** [expression] and all its subexpressions. */
internal fun withParts(expression: Expression): List<Expression> =
    listOf(expression) + expression.parts.flatMap(::withParts)

/** Every expression of a program. */
internal fun allExpressions(tree: SyntaxTree): List<Expression> =
    (allStatements(tree).flatMap { it.expressions } + tree.behaviours.map { it.condition }).flatMap(::withParts)

/** All statements of a program, including nested ones. */
internal fun allStatements(tree: SyntaxTree): List<Statement> = (
    tree.routines.flatMap {
        it.body
    } + tree.behaviours.flatMap { it.body } + tree.statements
).flatMap(::withStatements)

/** The light sensor's port, 1 to 3. */
internal fun lightPort(tree: SyntaxTree): Int = tree.robot?.lightSensor?.port ?: RobotConstants.LIGHT_PORT

private fun withStatements(statement: Statement): List<Statement> =
    listOf(statement) + statement.bodies.flatten().flatMap(::withStatements)
