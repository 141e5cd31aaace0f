package robotran.robolang.syntax

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

private fun withStatements(statement: Statement): List<Statement> =
    listOf(statement) + statement.bodies.flatten().flatMap(::withStatements)
