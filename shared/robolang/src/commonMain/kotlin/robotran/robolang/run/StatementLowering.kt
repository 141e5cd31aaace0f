package robotran.robolang.run

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.leadingDeclarations

/** Lowers statements, with [LoopLowering] for loops and [CommandLowering] for commands. */
internal class StatementLowering(private val emitter: Emitter, private val scope: LoweringScope) {
    val expressions = ExpressionLowering(emitter, scope)
    private val commands = CommandLowering(emitter, expressions, scope.kind)
    private val loops = LoopLowering(emitter, expressions, ::lowerBody)
    private var returned = ValueType.NOTHING

    /** The main program. Its behaviours start after the declarations at its beginning. */
    fun lowerMain(tree: SyntaxTree) = emitter.inBlock {
        val declarations = tree.leadingDeclarations
        declarations.forEach(::lower)
        emitter.emit { it.machine.isWatching = true }
        tree.statements.drop(declarations.size).forEach(::lower)
        if (tree.behaviours.isEmpty() && scope.stopsAtEnd) commands.lowerStop()
    }

    fun lowerRoutine(routine: Routine) = emitter.inBlock {
        returned = scope.symbolOf(routine.name).type
        routine.parameters.forEach { emitter.declare(scope.symbolOf(it)) }
        lowerBody(routine.body)
    }

    /** The statements of a block. */
    fun lowerBody(statements: List<Statement>) = emitter.inBlock { statements.forEach(::lower) }

    private fun lower(statement: Statement) {
        if (statement !is Statement.Loop) emitter.statement(statement.range.line)
        when (statement) {
            is Command -> commands.lower(statement)
            is Statement.Loop -> loops.lower(statement)
            is Statement.If -> lowerIf(statement)

            is Statement.Declare -> {
                expressions.lower(statement.value, scope.symbolOf(statement.name).type)
                expressions.store(statement.name)
                emitter.declare(scope.symbolOf(statement.name))
            }

            is Statement.Assign -> lowerAssign(statement)
            is Statement.Call -> expressions.call(statement.name, statement.arguments, isValueNeeded = false)
            is Statement.Return -> lowerReturn(statement)
            is Statement.Break -> loops.leave()
            is Statement.Continue -> loops.nextRound()

            is Statement.Halt -> {
                if (scope.stopsAtEnd) commands.lowerStop()
                emitter.emit { it.machine.isHalted = true }
            }
        }
    }

    private fun lowerIf(statement: Statement.If) {
        val end = Label()
        statement.branches.forEachIndexed { place, branch ->
            val otherwise = Label()
            if (place > 0) emitter.statement(branch.range.line)
            expressions.lower(branch.condition)
            emitter.jumpIfFalse(otherwise)
            lowerBody(branch.body)
            emitter.jump(end)
            emitter.put(otherwise)
        }
        statement.otherwise?.let { lowerBody(it.body) }
        emitter.put(end)
    }

    private fun lowerAssign(statement: Statement.Assign) {
        when (val target = statement.target) {
            is AssignTarget.Variable -> {
                expressions.lower(statement.value, scope.symbolOf(target.name).type)
                expressions.store(target.name)
            }

            is AssignTarget.ListElement -> lowerElement(target.list, target, statement)
        }
    }

    private fun lowerElement(list: Name, target: AssignTarget.ListElement, statement: Statement.Assign) {
        expressions.load(list)
        expressions.lower(target.index)
        expressions.lower(statement.value, scope.symbolOf(list).type.element)
        emitter.emit {
            val value = it.pop()
            val index = it.pop()
            it.machine.lists[it.pop(), index] = value
        }
    }

    private fun lowerReturn(statement: Statement.Return) {
        if (statement.value == null) {
            emitter.emit { it.leave() }
        } else {
            expressions.lower(statement.value, returned)
            emitter.emit {
                val value = it.pop()
                it.leave()
                it.push(value)
            }
        }
    }
}
