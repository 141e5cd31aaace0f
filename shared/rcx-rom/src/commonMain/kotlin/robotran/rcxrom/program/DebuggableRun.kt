package robotran.rcxrom.program

/** A run that can be stopped before any statement and looked into. Looking changes nothing. */
interface DebuggableRun : ProgramRun {
    /** What the run is in the middle of, the innermost first; the main program is the last. */
    val callStack: List<CallFrame>

    /** The variables that the innermost of [callStack] knows, its own first. */
    val variables: List<VariableScope>

    /** The threads that live, in the order of their start; a language without threads has one. */
    val threads: List<ThreadView>
        get() {
            val callStack = callStack
            return listOf(
                ThreadView(
                    FIRST_THREAD,
                    callStack.lastOrNull()?.name.orEmpty(),
                    callStack = callStack,
                    isCurrent = true,
                ),
            )
        }

    /** What the thread with this number is doing, null if it does not live; the same as in [threads], but cheaper. */
    fun activityOf(thread: Int): ThreadActivity? = threads.find { it.number == thread }?.activity

    /**
     * The variables that a routine knows, its own first.
     *
     * @param thread the number of one of [threads].
     * @param frame a place in its call stack, 0 for the innermost. Where there is nothing to be seen, the list is
     * empty.
     */
    fun variablesOf(thread: Int, frame: Int): List<VariableScope> =
        if (thread == FIRST_THREAD && frame == 0) variables else emptyList()

    /** How many statements have been begun so far. */
    val statementsBegun: Long

    /** Whether the run stands before a statement rather than in the middle of one. */
    val isBeforeStatement: Boolean

    /** Asked before each statement once; null asks nobody. */
    var watch: StatementWatch?

    companion object {
        /** The number of the thread that a program begins with. */
        const val FIRST_THREAD = 0
    }
}

/** Decides where a [DebuggableRun] stops; as long as it does not, it changes nothing about the run. */
fun interface StatementWatch {
    /**
     * Whether the run is to stop: [ProgramRun.resume] returns [ProgramStatus.Paused], and goes on with [statement],
     * which is about to be executed, when called again.
     */
    fun pausesBefore(statement: Statement): Boolean
}

/**
 * A statement that is about to be executed.
 *
 * @property sourceLine its line, from 1.
 * @property depth how many routines and behaviours it is inside of, 0 in the main program.
 * @property thread the number of the thread that executes it.
 * @property sourceFile the file it stands in; null if the program has only one.
 */
data class Statement(
    val sourceLine: Int,
    val depth: Int,
    val thread: Int = DebuggableRun.FIRST_THREAD,
    val sourceFile: String? = null,
)

/** How far a step goes. */
enum class StepKind {
    /** To the next statement, wherever it is. */
    INTO,

    /** To the next statement that is not inside a routine called by this one. */
    OVER,

    /** To the next statement behind the call of this routine. */
    OUT,
}

/**
 * A routine, a behaviour or the main program that is being executed.
 *
 * @property name of the routine, of the program, or the word that begins a behaviour.
 * @property sourceLine the line it is at, from 1.
 * @property sourceFile the file it stands in; null if the program has only one.
 */
data class CallFrame(val name: String, val sourceLine: Int, val sourceFile: String? = null)

/**
 * The variables of a routine or of the main program.
 *
 * @property name of the routine or of the program.
 */
data class VariableScope(val name: String, val variables: List<VariableView>)

/**
 * A variable and what is in it.
 *
 * @property value as the program would write it down, such as `7`, `2.5`, `true` or `[1, 2]`.
 */
data class VariableView(val name: String, val value: String)
