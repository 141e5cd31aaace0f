package robotran.nqc.messages

import robotran.nqc.config.ParameterLimit

/** The messages about what the brick cannot do. */
interface NqcCodeMessages {
    fun noStorage(): String

    /** A subroutine that several tasks call has more variables than it can. */
    fun noStorageInSharedSub(): String

    /** The variables of the subroutine [name] and of its caller do not fit together. */
    fun noStorageForSub(name: String): String

    fun noTemporaries(): String

    fun constantNeeded(): String

    fun shiftNeedsConstant(): String

    fun numberOutOfRange(number: Int): String

    /** @param kept what the brick keeps of [number]. */
    fun numberCut(number: Int, kept: Int): String

    fun caseOutOfRange(): String

    fun notAssignable(): String

    /** For `++` and `--`. */
    fun notSteppable(): String

    fun wrongSource(): String

    fun nestedAcquire(): String

    fun nestedMonitor(): String

    fun continueOutsideLoop(): String

    fun breakOutsideLoop(): String

    fun caseOutsideSwitch(): String

    /** @param value null for `default`. */
    fun duplicateCase(value: Int?): String

    fun wrongEventSource(): String

    fun taskNumberUnknown(): String

    fun addressNotConstant(): String

    /**
     * @param isError whether a constant is divided, which has no value; otherwise the brick does nothing.
     * @param isModulo whether `%` divides.
     */
    fun dividedByZero(isError: Boolean, isModulo: Boolean): String

    /** @param limit max elements of an array. */
    fun wrongArraySize(limit: Int): String

    fun indexOutside(name: String, last: Int): String

    fun codeTooLong(limit: Int): String

    /** @param bytes the size of the program. */
    fun memoryFull(bytes: Int, limit: Int): String

    /**
     * @param port from 1.
     * @param call the command that is missing, without a semicolon.
     */
    fun sensorNotSet(port: Int, call: String): String

    /** The constant [value] of an argument makes no sense. */
    fun argumentRange(limit: ParameterLimit, value: Int): String
}
