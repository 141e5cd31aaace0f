package robotran.robolang.translate

import robotran.robolang.run.RobotConstants
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree

/** The expressions that [statement] has itself, not those of the statements inside it. */
internal fun expressionsIn(statement: Statement): List<Expression> = when (statement) {
    is Statement.Move -> listOfNotNull(statement.distance, statement.duration)
    is Statement.Turn -> listOfNotNull(statement.angle, statement.duration)
    is Statement.Power -> listOf(statement.power)
    is Statement.Motor -> listOfNotNull((statement.command as? MotorCommand.Power)?.power)
    is Statement.Wait -> listOf(statement.duration)
    is Statement.WaitUntil -> listOf(statement.condition)
    is Statement.Play -> listOf(statement.frequency, statement.duration)
    is Statement.Show -> listOf(statement.value)
    is Statement.Repeat -> listOf(statement.count)
    is Statement.RepeatWhile -> listOf(statement.condition)
    is Statement.RepeatUntil -> listOf(statement.condition)
    is Statement.ForRange -> listOfNotNull(statement.from, statement.to, statement.step)
    is Statement.ForEach -> listOf(statement.list)
    is Statement.If -> statement.branches.map { it.condition }
    is Statement.Declare -> listOf(statement.value)
    is Statement.Assign -> listOfNotNull((statement.target as? AssignTarget.Element)?.index, statement.value)
    is Statement.Call -> statement.arguments
    is Statement.Return -> listOfNotNull(statement.value)
    else -> emptyList()
}

/** [expression] and everything in it. */
internal fun withParts(expression: Expression): List<Expression> = listOf(expression) + when (expression) {
    is Expression.ListOf -> expression.elements
    is Expression.Element -> listOf(expression.list, expression.index)
    is Expression.Unary -> listOf(expression.operand)
    is Expression.Binary -> listOf(expression.left, expression.right)
    is Expression.Call -> expression.arguments
    is Expression.Brackets -> listOf(expression.inner)
    is Expression.Number, is Expression.Truth, is Expression.Variable, is Expression.Sense -> emptyList()
}.flatMap(::withParts)

/** Every expression of a program. */
internal fun allExpressions(tree: SyntaxTree): List<Expression> {
    val blocks = tree.routines.map { it.body } + tree.behaviours.map { it.body } + listOf(tree.statements)
    val own = blocks.flatten().flatMap(::withStatements).flatMap(::expressionsIn)
    return (own + tree.behaviours.map { it.condition }).flatMap(::withParts)
}

/** The port, 1 to 3, that the light sensor is on. */
internal fun lightPort(tree: SyntaxTree): Int = tree.robot?.lightSensor?.port ?: RobotConstants.LIGHT_PORT

private fun withStatements(statement: Statement): List<Statement> =
    listOf(statement) + statementsIn(statement).flatten().flatMap(::withStatements)
