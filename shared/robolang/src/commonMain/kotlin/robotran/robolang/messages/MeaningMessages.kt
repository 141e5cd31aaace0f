package robotran.robolang.messages

/**
 * What is told about lines that can be read but make no sense: names, kinds of values, ways through the program,
 * limits.
 */
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

    /** A value is given to [name], which nothing declares. */
    fun undeclaredVariable(name: String): String

    /** The procedure or function [routine] is called above [line], where the [variable] is declared that it uses. */
    fun calledBeforeDeclaration(routine: String, variable: String, line: Int): String

    /** The [variable] is declared with a value for which [routine] is called, and that uses the variable. */
    fun calledInDeclaration(routine: String, variable: String): String

    /** A `whenever` uses [variable], which is declared in [line], below other commands. */
    fun neededBeforeDeclaration(variable: String, line: Int): String

    /** [name], declared with `var` in [line], is declared with `var` again. */
    fun redeclared(name: String, line: Int): String

    /** [right] says the same as `3 < x < 5` should. */
    fun chainedComparison(right: String): String
}
