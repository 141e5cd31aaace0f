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
        is Statement.Move -> listOfNotNull(distance, duration)
        is Statement.Turn -> listOfNotNull(angle, duration)
        is Statement.Power -> listOf(power)
        is Statement.Motor -> listOfNotNull((command as? MotorCommand.Power)?.power)
        is Statement.MotorTurn -> listOf(angle)
        is Statement.Wait -> listOf(duration)
        is Statement.WaitUntil -> listOf(condition)
        is Statement.Play -> listOf(frequency, duration)
        is Statement.Show -> listOf(value)
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
        is Statement.StartMoving,
        is Statement.StartTurning,
        is Statement.StopDriving,
        is Statement.Pen,
        is Statement.ResetMotor,
        is Statement.ResetTimer,
        is Statement.Beep,
        is Statement.Buzz,
        is Statement.ShowText,
        is Statement.ClearScreen,
        is Statement.RepeatForever,
        is Statement.Break, is Statement.Continue, is Statement.Halt,
        -> emptyList()
    }

/** The bodies directly inside this statement. */
internal val Statement.bodies: List<List<Statement>>
    get() = when (this) {
        is Statement.Loop -> listOf(body)
        is Statement.If -> branches.map { it.body } + listOfNotNull(otherwise?.body)
        else -> emptyList()
    }
