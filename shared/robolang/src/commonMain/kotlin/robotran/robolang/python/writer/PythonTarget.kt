package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree

/**
 * What Python for one kind of robot has of its own: its modules, how the robot is told and asked, how it waits and counts,
 * and what stands around the program. All else is the same on each, and is written once.
 */
internal interface PythonTarget {
    val arithmetic: PythonArithmetic

    /** The module with `sqrt` and the like. */
    val mathsModule: String

    /** The names that it uses besides imports and helpers. */
    val names: Set<String>

    /** Whether all declarations above the first other statement stand above the functions, if there are any. */
    val hoistsDeclarations: Boolean

    fun textOf(helper: PythonHelper): String

    fun linesOf(command: Command): List<String>

    /** Whether [command] lets time go by. */
    fun takesTime(command: Command): Boolean

    /** What lets time go by in a loop that waits for nothing. */
    fun pause(): String

    /** What a loop does in each round that neither waits nor senses; null if nothing. */
    fun look(): String? = null

    /** Lines behind [statement], apart from loops and choices. */
    fun linesBehind(statement: Statement): List<String> = emptyList()

    fun halt(place: PythonPlace): List<String>

    /** What [expression] senses. */
    fun reading(expression: Expression.Sense): PythonText

    fun colour(expression: Expression.ColourLiteral): PythonText

    /** [call], which is one of [routine]. */
    fun called(routine: Symbol, call: String): PythonText = primary(call)

    /** Whether [expression] is written with a function that only stands further down. */
    fun needsFunction(expression: Expression): Boolean

    /** Variables of the translation itself that [statement] changes. */
    fun variablesChangedBy(statement: Statement): List<String> = emptyList()

    /** Tells what is different about the program as a whole. */
    fun tell(tree: SyntaxTree) = Unit

    /** Keeps what is used so far; what comes back takes back all that is used since. */
    fun checkpoint(): () -> Unit

    /** Writes [routine] by [write]. */
    fun routine(routine: Routine, symbol: Symbol, parts: PythonParts, write: (prefix: String, PythonPlace) -> Unit)

    /** Writes what the robot consists of, or its figures, below the imports. */
    fun writeHead(writer: PythonWriter)

    /** Writes the figures of its commands, below that. */
    fun writeConstants(writer: PythonWriter)

    /** Writes its variables, below the pupil's own figures. */
    fun writeState(writer: PythonWriter)

    /** Writes the main program to [main] and what it needs of functions behind those of the program. */
    fun writeMain(parts: PythonParts, functions: PythonWriter, main: PythonWriter)
}

/** What a [PythonTarget] is made of: it serves one translation. */
internal class PythonContext(
    val program: CheckedProgram,
    val names: PythonNames,
    val uses: PythonUses,
    val notes: PythonNotes,
) {
    val tree: SyntaxTree get() = program.tree
    val isReacting: Boolean get() = tree.behaviours.isNotEmpty()

    /** What writes expressions; only asked once a target is made. */
    lateinit var expressions: PythonExpressions
}

/** A function that a translation contains only if it is used. */
internal interface PythonHelper {
    /** Its name. */
    val called: String

    /** What it uses, which is above it. */
    val needs: List<PythonHelper>

    /** What it imports, such as `umath:floor`. */
    val imports: List<String>

    /** Its names in the program. */
    val names: List<String>

    /** Its place among all. */
    val ordinal: Int
}
