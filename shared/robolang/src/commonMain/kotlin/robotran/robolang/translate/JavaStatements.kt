package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Statement

/** Writes statements as Java lines and blocks. */
internal class JavaStatements(
    private val program: CheckedProgram,
    private val names: JavaNames,
    private val expressions: JavaExpressions,
    private val helpers: UsedHelpers,
    texts: JavaShownTexts,
    nxt: NxtCommands?,
    private val stopsAtEnd: Boolean,
    private val writer: JavaWriter,
) {
    private val flow = JavaFlow(program)
    private val commands = JavaCommands(flow, expressions, helpers, texts, nxt, writer)
    private val loops = JavaLoops(program, names, expressions, writer, ::block)

    /** The statements of one block, in a scope of its own. */
    fun block(statements: List<Statement>) {
        names.inScope { write(statements) }
    }

    /** [statements] in the current scope, with [before] before each of them. Unreachable ones become comments. */
    fun write(statements: List<Statement>, before: (Statement) -> Unit = {}) {
        val wasUnreachable = writer.isUnreachable
        for (statement in statements) {
            before(statement)
            write(statement)
            if (!flow.completes(statement) && statement != statements.last() && !writer.isUnreachable) {
                writer.line("// The program never gets to the lines below.")
                writer.isUnreachable = true
            }
        }
        writer.isUnreachable = wasUnreachable
    }

    private fun write(statement: Statement) {
        val line = statement.range.line
        when (statement) {
            is Command -> commands.write(statement)
            is Statement.Loop -> loops.write(statement)
            is Statement.If -> choose(statement)
            is Statement.Break -> writer.line("break;", line)
            is Statement.Continue -> writer.line("continue;", line)
            is Statement.Declare -> declare(statement)

            is Statement.Assign -> {
                writer.line(
                    "${target(statement.target)} = ${expressions.text(statement.value)};",
                    line,
                )
            }

            is Statement.Call -> call(statement)

            is Statement.Return -> {
                writer.line(
                    statement.value?.let {
                        "return ${expressions.text(it)};"
                    } ?: "return;",
                    line,
                )
            }

            is Statement.Halt -> {
                if (stopsAtEnd) writer.line("${helpers.use(JavaHelper.PILOT_FIELD)}.stop();", line)
                writer.line("System.exit(0);", line)
            }
        }
    }

    private fun choose(statement: Statement.If) {
        statement.branches.forEachIndexed { index, branch ->
            val opening = "if (${expressions.text(branch.condition)})"
            if (index == 0) {
                writer.open(opening, branch.range.line)
            } else {
                writer.reopen("else $opening", branch.range.line)
            }
            block(branch.body)
        }
        statement.otherwise?.let {
            writer.reopen("else", it.range.line)
            block(it.body)
        }
        writer.close(statement.endRange.line)
    }

    /** Assigns a global, which has its field; declares anything else. */
    private fun declare(statement: Statement.Declare) {
        val symbol = program.symbolOf(statement.name)
        if (symbol.isGlobal) {
            writer.line("${names.of(symbol)} = ${expressions.text(statement.value)};", statement.range.line)
            return
        }
        val value = initial(statement.value)
        val final = if (statement.isConstant) "final " else ""
        val name = names.declareLocal(symbol)
        writer.line("$final${javaType(symbol.type)} $name = $value;", statement.range.line, names.noteOn(symbol))
    }

    /** [value] as an initialiser. */
    fun initial(value: Expression): String =
        if (value is Expression.ListOf) expressions.elements(value) else expressions.text(value)

    private fun target(target: AssignTarget): String = when (target) {
        is AssignTarget.Variable -> nameOf(target.name)
        is AssignTarget.ListElement -> "${nameOf(target.list)}[${expressions.text(target.index)}]"
    }

    private fun call(statement: Statement.Call) {
        writer.line("${nameOf(statement.name)}(${expressions.arguments(statement.arguments)});", statement.range.line)
    }

    private fun nameOf(name: Name): String = names.of(program.symbolOf(name))

    /** A dummy value of [type] for the end of a function that Java considers reachable. */
    fun defaultOf(type: ValueType): String = when (type) {
        ValueType.WHOLE, ValueType.DECIMAL, ValueType.COLOUR -> "0"
        ValueType.TRUTH -> "false"
        ValueType.LIST_OF_WHOLE, ValueType.LIST_OF_DECIMAL, ValueType.NOTHING -> "null"
    }
}
