package robotran.robolang

/**
 * The table of everything Robolang says to a learner, one function a message. Another language is another implementation.
 * Words of the program arrive as they were typed, already shortened; suggestions arrive as Robolang spells them.
 */
interface RobolangMessages : RunMessages {
    /** [suggestion] is the command that was probably meant, null if nothing is near. */
    fun unknownCommand(word: String, suggestion: String?): String

    fun missingCommand(): String

    fun missingSpace(word: String, number: String): String

    /** [example] is a complete line that begins with [command]. */
    fun missingNumber(command: String, example: String): String

    fun missingTurnDirection(suggestion: String?): String

    fun missingPenPosition(suggestion: String?): String

    fun missingTimes(count: String, suggestion: String?): String

    fun missingTimeUnit(duration: String): String

    /** [units] are what [command] measures in; [suggestion] is the one that was probably meant. */
    fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?): String

    fun severalCommands(second: String): String

    /** [complete] is the part of the line that makes sense without [extra]. */
    fun extraWords(extra: String, complete: String): String

    fun missingEnd(block: String): String

    fun extraEnd(): String

    fun unknownCharacter(character: String): String

    /** [code] is the number of a character that leaves no mark on a screen, such as `U+200B`. */
    fun invisibleCharacter(code: String): String

    fun characterInsteadOf(written: String, right: String): String

    fun commentBegins(): String

    fun semicolon(): String

    fun numberTooLarge(smallest: Int, largest: Int): String

    /** [right] is the number that was probably meant. */
    fun malformedNumber(number: String, right: String?): String

    fun decimalComma(right: String?): String

    fun countNotWhole(count: String): String

    fun countNegative(count: String): String

    fun waitNegative(): String

    fun durationTooLong(): String

    fun nestedTooDeeply(limit: Int): String

    fun sourceTooLong(limit: Int): String

    fun unclosedText(): String

    fun useTwoEqualsSigns(): String

    fun useOneEqualsSign(): String

    fun combinedAssignment(name: String, operator: String): String

    fun missingCondition(command: String, example: String): String

    fun missingValue(command: String, example: String): String

    fun missingOperand(before: String): String

    fun missingAssignment(before: String, example: String): String

    fun missingName(before: String, example: String): String

    fun reservedWord(word: String): String

    fun missingBracket(opening: String, closing: String): String

    fun missingBracketsOfCall(name: String): String

    fun missingBracketsOfRoutine(name: String): String

    fun missingWord(before: String, word: String, suggestion: String?): String

    fun missingButton(suggestion: String?): String

    fun missingMove(suggestion: String?): String

    fun missingMotor(): String

    fun missingMotorCommand(motor: String, suggestion: String?): String

    fun missingFacing(suggestion: String?): String

    fun portOutOfRange(): String

    fun lengthAndTime(): String

    fun extraElse(): String

    fun notOutermost(word: String): String

    fun secondRobot(): String

    fun unknownSetting(): String

    fun secondSetting(): String

    fun expressionTooDeep(limit: Int): String

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

    fun tooManyConstants(limit: Int): String

    fun tooManyRoutines(limit: Int): String

    fun unusedVariable(name: String): String

    fun neverReached(word: String): String

    fun busyLoop(): String

    fun fractionLost(division: String, result: Int): String

    fun divisorTooLarge(divisor: Int): String

    fun listInLoop(): String
}
