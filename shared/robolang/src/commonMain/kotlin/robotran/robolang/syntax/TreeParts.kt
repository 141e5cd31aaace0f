package robotran.robolang.syntax

/** The declarations at the start of the main program; behaviours start after them. */
internal val SyntaxTree.leadingDeclarations: List<Statement>
    get() = statements.takeWhile { it is Statement.Declare }

/** The direct subexpressions, from left to right. */
internal val Expression.parts: List<Expression>
    get() = when (this) {
        is Expression.Number, is Expression.BooleanLiteral, is Expression.ColourLiteral, is Expression.Variable,
        is Expression.Sense,
        -> emptyList()
        is Expression.ListOf -> elements
        is Expression.ListElement -> listOf(list, index)
        is Expression.Unary -> listOf(operand)
        is Expression.Binary -> listOf(left, right)
        is Expression.Call -> arguments
        is Expression.Brackets -> listOf(inner)
    }

/** The expressions in the statement's own line, or in all branch lines of an `if`, without those in its bodies. */
internal val Statement.expressions: List<Expression>
    get() = when (this) {
        is Command -> values.map { it.first }
        is Statement.Repeat -> listOf(count)
        is Statement.RepeatWhile -> listOf(condition)
        is Statement.RepeatUntil -> listOf(condition)
        is Statement.ForRange -> listOfNotNull(from, to, step)
        is Statement.ForEach -> listOf(list)
        is Statement.If -> branches.map { it.condition }
        is Statement.Declare -> listOf(value)
        is Statement.Assign -> listOfNotNull((target as? AssignTarget.ListElement)?.index, value)
        is Statement.Call -> arguments
        is Statement.Return -> listOfNotNull(value)
        is Statement.RepeatForever, is Statement.Break, is Statement.Continue, is Statement.Halt -> emptyList()
    }

/** The bodies directly inside this statement. */
internal val Statement.bodies: List<List<Statement>>
    get() = when (this) {
        is Statement.Loop -> listOf(body)
        is Statement.If -> branches.map { it.body } + listOfNotNull(otherwise?.body)
        is Command, is Statement.Break, is Statement.Continue, is Statement.Declare, is Statement.Assign,
        is Statement.Call, is Statement.Return, is Statement.Halt,
        -> emptyList()
    }
