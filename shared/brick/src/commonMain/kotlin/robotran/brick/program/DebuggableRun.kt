package robotran.brick.program

/** A run that can be paused before any statement and inspected. Inspection changes nothing. */
interface DebuggableRun : ProgramRun {
    /** The active calls, innermost first; the main program is last. */
    val callStack: List<CallFrame>

    /** The variables visible in the innermost frame of [callStack], its own first. */
    val variables: List<VariableScope>

    /** The live threads in start order; a language without threads has one. */
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

    /** The activity of the thread with this number, null if it is not alive; the same as in [threads], but cheaper. */
    fun activityOf(thread: Int): ThreadActivity? = threads.find { it.number == thread }?.activity

    /**
     * The variables visible in a frame, its own first; empty if there are none to show.
     *
     * @param thread the number of one of [threads].
     * @param frame index in the thread's call stack, 0 for the innermost.
     */
    fun variablesOf(thread: Int, frame: Int): List<VariableScope> =
        if (thread == FIRST_THREAD && frame == 0) variables else emptyList()

    /** Number of statements started so far. */
    val statementsBegun: Long

    /** Whether the run is before a statement rather than in the middle of one. */
    val isBeforeStatement: Boolean

    /** The same for the thread with this number; false if it is not alive. */
    fun isBeforeStatement(thread: Int): Boolean =
        isBeforeStatement && threads.any { it.isCurrent && it.number == thread }

    /** Called once before each statement, unless null. */
    var watch: StatementWatch?

    companion object {
        /** The number of the program's first thread. */
        const val FIRST_THREAD = 0
    }
}

/** Decides where a [DebuggableRun] pauses. Unless it pauses the run, it does not affect it. */
fun interface StatementWatch {
    /**
     * Whether to pause before [statement]. If true, [ProgramRun.resume] returns [ProgramStatus.Paused]; the next call
     * continues with [statement].
     */
    fun pausesBefore(statement: DebugStatement): Boolean
}

/**
 * A statement that is about to be executed.
 *
 * @property sourceLine its line, from 1.
 * @property depth the number of enclosing routine and behaviour calls, 0 in the main program.
 * @property thread the number of the thread that executes it.
 * @property sourceFile its file; null if the program has only one.
 */
data class DebugStatement(
    val sourceLine: Int,
    val depth: Int,
    val thread: Int = DebuggableRun.FIRST_THREAD,
    val sourceFile: String? = null,
)

enum class StepKind {
    /** To the next statement, wherever it is. */
    INTO,

    /** To the next statement outside the routines that this one calls. */
    OVER,

    /** To the next statement after the call of this routine. */
    OUT,
}

/**
 * An active call of a routine or behaviour, or the main program.
 *
 * @property name of the routine or program, or the keyword that starts the behaviour.
 * @property sourceLine the current line, from 1.
 * @property sourceFile its file; null if the program has only one.
 */
data class CallFrame(val name: String, val sourceLine: Int, val sourceFile: String? = null)

/**
 * The variables of a routine or of the main program.
 *
 * @property name of the routine or program.
 */
data class VariableScope(val name: String, val variables: List<VariableView>)

/**
 * A variable and its value.
 *
 * @property value in source notation, such as `7`, `2.5`, `true` or `[1, 2]`.
 */
data class VariableView(val name: String, val value: String)
