package robotran.robolang.messages

import robotran.language.pasted.PastedCharacter

/** The messages about syntax errors. Suggestions have the spelling of Robolang. */
interface SyntaxMessages {
    /** [suggestion] is the command that was probably meant; null if none is similar. */
    fun unknownCommand(word: String, suggestion: String?): String

    fun missingCommand(): String

    fun missingSpace(word: String, number: String): String

    /** [example] is a complete line that begins with [command]. */
    fun missingNumber(command: String, example: String): String

    /** [start] is the command that drives until something else happens. */
    fun startInstead(start: String): String

    fun missingTurnDirection(suggestion: String?): String

    fun missingPenPosition(suggestion: String?): String

    fun missingTimes(count: String, suggestion: String?): String

    fun missingTimeUnit(duration: String): String

    /** [units] are the valid units of [command]; [suggestion] is the one that was probably meant. */
    fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?): String

    fun severalCommands(second: String): String

    /** [complete] is the part of the line before [extra], a complete command. */
    fun extraWords(extra: String, complete: String): String

    fun missingEnd(block: String): String

    fun extraEnd(): String

    fun unknownCharacter(character: String): String

    /** [code] is the code point of the character, such as `U+200B`. */
    fun invisibleCharacter(code: String): String

    /** @param written [pasted], and what was pasted behind it. */
    fun pastedCharacter(pasted: PastedCharacter, written: String): String

    fun characterInsteadOf(written: String, right: String): String

    fun commentBegins(): String

    fun semicolon(): String

    fun numberTooLarge(smallest: Int, largest: Int): String

    /** [right] is the number that was probably meant. */
    fun malformedNumber(number: String, right: String?): String

    fun decimalComma(right: String?): String

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

    fun lengthAndTime(): String

    fun extraElse(): String

    fun notOutermost(word: String): String

    fun secondRobot(): String

    fun unknownSetting(): String

    fun secondSetting(): String

    fun expressionTooDeep(limit: Int): String

    /** [word] can begin a value but not a line. */
    fun valueAsCommand(word: String): String

    fun settingOutsideRobot(): String

    fun colon(): String

    /** [brace] is `{` or `}`. */
    fun brace(brace: String): String

    fun malformedName(name: String): String

    /** @param right the name as one word. */
    fun nameOfSeveralWords(right: String): String

    /** [second] is the text after the missing comma. */
    fun missingComma(second: String): String

    fun textAsValue(text: String): String
}
