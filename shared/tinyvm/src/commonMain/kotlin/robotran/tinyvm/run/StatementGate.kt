package robotran.tinyvm.run

import robotran.brick.program.DebugStatement
import robotran.brick.program.StatementWatch

/** Counts the program's statements and asks [watch] once before each of them whether to pause. */
internal class StatementGate {
    private var isPassed = false

    /** The number of statements begun. */
    var begun = 0L
        private set

    /** The debugger's watch, null if there is none. */
    var watch: StatementWatch? = null

    /** Describes the statement on a line, which a thread is about to begin, for [watch]. */
    var statementOf: (VmThread, Int) -> DebugStatement = { _, line -> DebugStatement(line, 0) }

    val isWatched: Boolean get() = watch != null

    /** Whether [thread] may begin the statement on [line]. The call after a refusal always returns true. */
    fun mayBegin(thread: VmThread, line: Int): Boolean {
        if (!isPassed && watch?.pausesBefore(statementOf(thread, line)) == true) {
            isPassed = true
            return false
        }
        begin()
        return true
    }

    /** Begins a statement without asking [watch]. */
    fun begin() {
        isPassed = false
        begun++
    }
}
