package robotran.robolang.nqc

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Branch
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement
import robotran.robolang.translate.JavaWriter

/** Writes statements as NQC lines and blocks. A statement that loses something is a comment with the reason. */
internal class NqcStatements(
    private val program: CheckedProgram,
    private val names: NqcNames,
    private val expressions: NqcExpressions,
    private val helpers: UsedNqcHelpers,
    private val recursive: RecursiveRoutines,
    private val lists: KnownLists,
    private val notes: TranslationNotes,
    private var writer: JavaWriter,
) {
    private val commands = NqcCommands(expressions, helpers, notes)
    private val loops = NqcLoops(program, names, expressions, lists, notes, this)

    /** The parameter for the value of the function around; null outside of functions. */
    private var result: String? = null

    fun inRoutine(result: String?, write: () -> Unit) {
        this.result = result
        write()
        this.result = null
    }

    /** Writes with [write] into [other]. */
    fun into(other: JavaWriter, write: () -> Unit) {
        val outer = writer
        writer = other
        write()
        writer = outer
    }

    fun block(statements: List<Statement>) = names.inScope { write(statements) }

    /** [statements] in the current scope, with [before] before each of them. */
    fun write(statements: List<Statement>, before: (Statement) -> Unit = {}) = statements.forEach {
        before(it)
        write(it)
    }

    private fun write(statement: Statement) {
        fun line(lines: () -> List<String>) = lines(statement.range.line, lines)

        when (statement) {
            is Command -> line { commands.linesOf(statement) }
            is Statement.Loop -> loops.write(statement)
            is Statement.If -> choose(statement, 0)
            is Statement.Break -> line { listOf("break;") }
            is Statement.Continue -> line { listOf("continue;") }
            is Statement.Declare -> line { declare(statement) }
            is Statement.Assign -> line { assign(statement) }
            is Statement.Call -> line { call(statement) }
            is Statement.Return -> line { returning(statement) }
            is Statement.Halt -> line { listOf("Off(OUT_A + OUT_B + OUT_C);", "StopAllTasks();") }
        }
    }

    /** Writes lines and the calls that come before them; if something is lost, the reason instead. */
    fun lines(line: Int, write: () -> List<String>): Boolean {
        val lost = notes.lostCount
        val (texts, calls) = expressions.withCalls(write)
        if (notes.lostCount > lost) {
            writer.line("// ${notes.lastLost}", line)
            return false
        }
        (calls + texts).forEach { writer.line(it, line) }
        return true
    }

    private fun declare(statement: Statement.Declare): List<String> {
        val symbol = program.symbolOf(statement.name)
        if (expressions.isWrittenDown(symbol)) return emptyList()
        val list = expressions.bare(statement.value)
        if (lists.sizeOf(symbol) != null && list is Expression.ListOf) {
            val name = if (symbol.isGlobal) names.of(symbol) else names.declareLocal(symbol)
            return listOfNotNull(if (symbol.isGlobal) null else "int $name[${list.elements.size}];") +
                elements(name, list)
        }
        if (symbol.type.isList) return lost(statement, notes.messages.list())
        if (symbol.type == ValueType.DECIMAL) return lost(statement, notes.messages.decimal())
        val value = expressions.text(statement.value)
        if (symbol.isGlobal) return listOf("${names.of(symbol)} = $value;")
        return listOf("int ${names.declareLocal(symbol)} = $value;")
    }

    private fun assign(statement: Statement.Assign): List<String> {
        val target = when (val target = statement.target) {
            is AssignTarget.Variable -> target
            is AssignTarget.ListElement -> return assignElement(statement, target)
        }
        val symbol = program.symbolOf(target.name)
        if (symbol.type.isList) return lost(statement, notes.messages.list())
        if (symbol.type == ValueType.DECIMAL) return lost(statement, notes.messages.decimal())
        return listOf("${names.of(symbol)} = ${expressions.text(statement.value)};")
    }

    private fun assignElement(statement: Statement.Assign, target: AssignTarget.ListElement): List<String> {
        val symbol = program.symbolOf(target.list)
        if (lists.sizeOf(symbol) == null) return lost(statement, notes.messages.list())
        val place = "${names.of(symbol)}[${expressions.text(target.index)}]"
        return listOf("$place = ${expressions.text(statement.value)};")
    }

    /** Assigns the elements of [list] to the array [name]. */
    fun elements(name: String, list: Expression.ListOf): List<String> =
        list.elements.mapIndexed { index, element -> "$name[$index] = ${expressions.text(element)};" }

    private fun call(statement: Statement.Call): List<String> {
        if (recursive.isCalledBy(statement.name)) {
            return lost(statement, notes.messages.recursion(statement.name.text))
        }
        val arguments = statement.arguments.joinToString { expressions.text(it) }
        return listOf("${names.of(program.symbolOf(statement.name))}($arguments);")
    }

    private fun returning(statement: Statement.Return): List<String> {
        val value = statement.value ?: return listOf("return;")
        return listOf("$result = ${expressions.text(value)};", "return;")
    }

    private fun lost(statement: Statement, message: String): List<String> {
        notes.lost(statement.range, message)
        return emptyList()
    }

    /** Writes the branches of [statement] from number [first] on. */
    private fun choose(statement: Statement.If, first: Int) {
        val branches = statement.branches.drop(first)
        if (!lines(branches.first().range.line) { open(branches.first()) }) return
        writer.enter()
        block(branches.first().body)
        for ((index, branch) in branches.withIndex().drop(1)) {
            val lost = notes.lostCount
            val (condition, calls) = expressions.withCalls { expressions.text(branch.condition) }
            if (calls.isNotEmpty() || notes.lostCount > lost) {
                nested(statement, first + index)
                return
            }
            writer.reopen("else if ($condition)", branch.range.line)
            block(branch.body)
        }
        statement.otherwise?.let {
            writer.reopen("else", it.range.line)
            block(it.body)
        }
        writer.close(statement.endRange.line)
    }

    private fun open(branch: Branch): List<String> = listOf("if (${expressions.text(branch.condition)}) {")

    /** The branches from number [first] on, whose condition needs lines of its own. */
    private fun nested(statement: Statement.If, first: Int) {
        writer.reopen("else", statement.branches[first].range.line)
        choose(statement, first)
        writer.close(statement.endRange.line)
    }

    /** Writes a block that begins with [head], and the calls that come before it. */
    fun around(line: Int, end: Int, head: () -> String, body: () -> Unit) {
        val isComplete = lines(line) { listOf("${head()} {") }
        if (!isComplete) return
        writer.enter()
        body()
        writer.close(end)
    }

    /** The expression as NQC, and whether calls must come before it. */
    fun condition(expression: Expression, isOpposite: Boolean): Pair<String, List<String>> =
        expressions.withCalls { text(expression, isOpposite) }

    fun text(expression: Expression, isOpposite: Boolean): String =
        if (isOpposite) "!(${expressions.text(expression)})" else expressions.text(expression)
}
