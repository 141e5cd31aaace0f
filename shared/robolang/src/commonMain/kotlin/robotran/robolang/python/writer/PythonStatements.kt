package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts

/** Writes statements as lines and blocks. A statement that loses something is a comment with the reason. */
internal class PythonStatements(
    private val program: CheckedProgram,
    private val names: PythonNames,
    private val expressions: PythonExpressions,
    private val target: PythonTarget,
    private val notes: PythonNotes,
    private val writer: PythonWriter,
    private val place: PythonPlace,
) {
    private val loops = PythonLoops(program, names, expressions, target, this)

    /** Whether [statement] itself lets time go by; a reading does not count. */
    fun takesTime(statement: Statement): Boolean = waits(statement, emptySet())

    private fun waits(statement: Statement, seen: Set<String>): Boolean {
        val isLong = statement is Command && target.takesTime(statement)
        val calls = listOfNotNull((statement as? Statement.Call)?.name) +
            statement.expressions.flatMap(::withParts).mapNotNull { (it as? Expression.Call)?.name }
        return isLong || calls.map { it.key }.filter { it !in seen }.any { called ->
            routines[called]?.let { routine -> withInner(routine.body).any { waits(it, seen + called) } } == true
        }
    }

    private val routines = program.tree.routines.associateBy { it.name.key }

    /** [statements] in the block that is open, which ends at [lastLine]. */
    fun block(statements: List<Statement>, lastLine: Int, pause: PythonPause? = null, next: String? = null) {
        writer.enterBlock()
        if (pause?.isFirst == true) writer.line(pause.line)
        write(statements)
        writer.commentsAbove(lastLine + 1)
        if (pause?.isFirst == false) writer.line(pause.line)
        next?.let { writer.line(it) }
        writer.close()
    }

    /** [statements] in a scope of their own, with [before] before each of them. */
    fun write(statements: List<Statement>, before: (Statement) -> Unit = {}) = names.inScope {
        writeHere(statements, before)
    }

    /** [statements] in the scope that is open. */
    fun writeHere(statements: List<Statement>, before: (Statement) -> Unit = {}) = statements.forEach {
        before(it)
        write(it)
    }

    private fun write(statement: Statement) {
        writer.begin(statement.range.line)
        place.linesBefore(statement).forEach { writer.line(it) }
        when (statement) {
            is Statement.Loop -> loops.write(statement)
            is Statement.If -> choose(statement)

            else -> {
                lines(statement.range.line) { linesOf(statement) to noteOn(statement) }
                target.linesBehind(statement).forEach { writer.line(it) }
            }
        }
    }

    private fun noteOn(statement: Statement): String? =
        (statement as? Statement.Declare)?.let { names.noteOn(program.symbolOf(it.name)) }

    private fun linesOf(statement: Statement): List<String> = when (statement) {
        is Command -> target.linesOf(statement)
        is Statement.Break -> listOf("break")
        is Statement.Continue -> loops.onContinue + "continue"
        is Statement.Declare -> listOf(declare(statement))
        is Statement.Assign -> listOf(assign(statement))
        is Statement.Call -> listOf(expressions.call(program.symbolOf(statement.name), statement.arguments).text)
        is Statement.Return -> listOf(returned(statement))
        is Statement.Halt -> target.halt(place)
        is Statement.Loop, is Statement.If -> error("A block is no line.")
    }

    private fun declare(statement: Statement.Declare): String {
        val symbol = program.symbolOf(statement.name)
        val value = expressions.text(statement.value, symbol.type)
        val name = if (symbol.isGlobal) names.of(symbol) else names.declareLocal(symbol)
        return "$name = $value"
    }

    private fun assign(statement: Statement.Assign): String = when (val target = statement.target) {
        is AssignTarget.Variable -> {
            val symbol = program.symbolOf(target.name)
            "${names.of(symbol)} = ${expressions.text(statement.value, symbol.type)}"
        }

        is AssignTarget.ListElement -> {
            val symbol = program.symbolOf(target.list)
            val value = expressions.text(statement.value, symbol.type.element)
            this.target.arithmetic.setElement(target.list, target.index, value)
        }
    }

    private fun returned(statement: Statement.Return): String {
        val value = statement.value ?: return "return"
        val wanted = place.result
        return "return " + if (wanted == null) expressions.text(value) else expressions.text(value, wanted)
    }

    /**
     * Writes the lines of [write], with the note on the first of them; if something is lost, the reason instead. Returns
     * whether nothing was.
     */
    fun lines(line: Int, write: () -> Pair<List<String>, String?>): Boolean {
        val lost = notes.lostCount
        val takeBack = target.checkpoint()
        val (texts, note) = write()
        if (notes.lostCount > lost) {
            takeBack()
            writer.line("# ${notes.lastLost}", line)
            return false
        }
        texts.forEachIndexed { place, text -> writer.line(text, line, note.takeIf { place == 0 }) }
        return true
    }

    private fun choose(statement: Statement.If) {
        var isOpen = false
        for ((place, branch) in statement.branches.withIndex()) {
            val last =
                statement.branches.getOrNull(place + 1)?.range ?: statement.otherwise?.range ?: statement.endRange
            val word = if (isOpen) "elif" else "if"
            val isWritten = lines(branch.range.line) { listOf("$word ${expressions.text(branch.condition)}:") to null }
            if (!isWritten) continue
            isOpen = true
            block(branch.body, if (last == statement.endRange) last.line else last.line - 1)
        }
        val otherwise = statement.otherwise ?: return
        if (!isOpen) return
        writer.line("else:", otherwise.range.line)
        block(otherwise.body, statement.endRange.line)
    }
}

/** The [line] with which a loop waits for a moment in each round: its first, or its last. */
internal class PythonPause(val line: String, val isFirst: Boolean)
