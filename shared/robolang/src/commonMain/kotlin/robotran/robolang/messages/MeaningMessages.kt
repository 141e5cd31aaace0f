package robotran.robolang.messages

/** The messages about semantic errors: names, types, control flow and limits. */
interface MeaningMessages {
    fun unknownVariable(name: String, suggestion: String?): String

    fun unknownRoutine(name: String, suggestion: String?): String

    fun usedBeforeDeclaration(name: String, line: Int): String

    fun declaredTwice(name: String, line: Int): String

    fun declaredBuiltIn(name: String): String

    fun assignedConstant(name: String): String

    fun assignedLoopVariable(name: String): String

    fun numberNeeded(text: String): String

    fun wholeNumberNeeded(text: String): String

    fun conditionNeeded(text: String): String

    fun listNeeded(text: String): String

    fun valueNeeded(name: String): String

    fun decimalForWhole(name: String): String

    fun typeChanged(name: String): String

    fun notComparable(): String

    fun mixedList(text: String): String

    fun emptyList(): String

    fun listTooLong(limit: Int): String

    fun indexOutOfRange(last: Int): String

    fun indexNegative(): String

    fun wrongArgumentCount(name: String, needed: Int, given: Int): String

    fun functionAsCommand(name: String): String

    fun outsideLoop(word: String): String

    fun outsideRoutine(): String

    fun returnWithValue(name: String): String

    fun returnWithoutValue(name: String): String

    fun missingReturn(name: String): String

    fun durationNegative(): String

    fun powerOutOfRange(): String

    fun textTooLong(limit: Int): String

    fun textNotShown(character: String): String

    fun divisionByZero(): String

    fun stepZero(): String

    fun tooManyVariables(limit: Int): String

    fun tooManyParameters(limit: Int): String

    fun tooManyConstants(limit: Int): String

    fun tooManyRoutines(limit: Int): String

    fun countNotWhole(count: String): String

    fun countNegative(count: String): String

    fun waitNegative(): String

    fun durationTooLong(): String

    /** An assignment to the undeclared variable [name]. */
    fun undeclaredVariable(name: String): String

    /** [routine] is called before its [variable] is declared in [line]. */
    fun calledBeforeDeclaration(routine: String, variable: String, line: Int): String

    /** The initial value of [variable] calls [routine], which uses [variable] itself. */
    fun calledInDeclaration(routine: String, variable: String): String

    /** A `whenever` uses [variable], whose declaration in [line] comes after other commands. */
    fun neededBeforeDeclaration(variable: String, line: Int): String

    /** A second `var` for [name], which [line] declares. */
    fun redeclared(name: String, line: Int): String

    /** [right] is the valid spelling of a condition such as `3 < x < 5`. */
    fun chainedComparison(right: String): String
}
