package robotran.rom

/** A run that can be stopped before any statement and looked into. Looking changes nothing. */
interface DebuggableRun : ProgramRun {
    /** What the run is in the middle of, the innermost first; the main program is the last. */
    val callStack: List<CallFrame>

    /** The variables that the innermost of [callStack] knows, its own first. */
    val variables: List<VariableScope>

    /** How many statements have been begun so far. */
    val statementsBegun: Long

    /** Whether the run stands before a statement rather than in the middle of one. */
    val isBeforeStatement: Boolean

    /** Asked before each statement once; null asks nobody. */
    var watch: StatementWatch?
}

/** Decides where a [DebuggableRun] stops; as long as it does not, it changes nothing about the run. */
fun interface StatementWatch {
    /**
     * Whether the run is to stop: [ProgramRun.resume] returns [ProgramStatus.Paused], and goes on with this statement when called again.
     *
     * @param sourceLine the line of the statement about to be executed, from 1.
     * @param depth how many routines and behaviours it is inside of, 0 in the main program.
     */
    fun pausesBefore(sourceLine: Int, depth: Int): Boolean
}

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
 */
data class CallFrame(val name: String, val sourceLine: Int)

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
