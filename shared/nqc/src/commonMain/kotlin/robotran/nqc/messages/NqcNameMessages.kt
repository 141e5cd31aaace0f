package robotran.nqc.messages

/** The messages about names and calls. Suggestions are names that were probably meant; null if none is similar. */
interface NqcNameMessages {
    /** @param suggestion a task that was probably meant to be the main one. */
    fun mainMissing(suggestion: String?): String

    /** @param line where the name is declared; null if it is one of NQC's own. */
    fun redeclared(name: String, line: Int?): String

    fun undefinedVariable(name: String, suggestion: String?): String

    /** [name] would be one of a series, such as `OUT_D`, which has only [others]. */
    fun notOfSeries(name: String, others: List<String>): String

    /** A sensor is read by a call; [right] is its name. */
    fun sensorByName(right: String): String

    /** A line has nothing but [name], which means nothing. */
    fun undefinedCommand(name: String, suggestion: String?): String

    /** @param call how the function [name] is called. */
    fun bracketsMissing(name: String, call: String): String

    fun undefinedFunction(name: String, suggestion: String?): String

    fun undefinedTask(name: String, suggestion: String?): String

    /** [name] is a task, but is called. */
    fun taskCalled(name: String): String

    /** [name] is part of the API for firmware 2.0, but the program is for firmware 1.0. */
    fun needsSecondFirmware(name: String): String

    fun taskNeverStarted(name: String): String

    fun undefinedLabel(name: String): String

    fun labelRedefined(name: String): String

    fun initUndefined(name: String): String

    fun isArray(name: String): String

    fun isNotArray(name: String): String

    fun isNotPointer(name: String): String

    fun arrayInitialized(name: String): String

    /** @param call how the function [name] is called. */
    fun argumentCount(name: String, needed: Int, given: Int, call: String): String

    fun argumentNotConstant(): String

    fun argumentNotVariable(): String

    fun argumentNotSensor(): String

    fun argumentNotPointer(): String

    fun nestedSub(name: String): String

    fun recursion(name: String): String

    fun subParameters(target: String): String

    fun tooManyTasks(limit: Int): String

    fun tooManySubs(limit: Int): String

    fun pointerUnsupported(): String

    fun arrayUnsupported(): String

    fun acquireUnsupported(): String

    fun monitorUnsupported(): String
}
