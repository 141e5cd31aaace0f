package robotran.tinyvm.run

import robotran.rcxrom.program.Statement
import robotran.rcxrom.program.StatementWatch

/** Counts the statements of the program and asks somebody who watches before each of them once. */
internal class StatementGate {
    private var isPassed = false

    /** How many statements have been begun. */
    var begun = 0L
        private set

    /** Whom to ask; null for nobody. */
    var watch: StatementWatch? = null

    /** What [watch] is told of the statement on a line that a thread stands before. */
    var statementOf: (VmThread, Int) -> Statement = { _, line -> Statement(line, 0) }

    val isWatched: Boolean get() = watch != null

    /** Whether [thread] may begin the statement on [line]; it may after it was asked about. */
    fun mayBegin(thread: VmThread, line: Int): Boolean {
        if (!isPassed && watch?.pausesBefore(statementOf(thread, line)) == true) {
            isPassed = true
            return false
        }
        begin()
        return true
    }

    /** Begins a statement that nobody is asked about. */
    fun begin() {
        isPassed = false
        begun++
    }
}
