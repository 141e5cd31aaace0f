package robotran.robolang.messages

import robotran.language.quoted

/** What is told in English about lines that cannot be read. */
internal object EnglishSyntaxMessages : SyntaxMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "There is no command ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingCommand() = "A line begins with a command, such as \"forward 20\"."

    override fun missingSpace(word: String, number: String) =
        "Put a space between ${quoted(word)} and ${quoted(number)}."

    override fun missingNumber(command: String, example: String) =
        "After ${quoted(command)} comes a number, such as ${quoted(example)}."

    override fun missingTurnDirection(suggestion: String?) =
        "Say which way to turn: \"turn left 90\" or \"turn right 90\".${didYouMean(suggestion)}"

    override fun missingPenPosition(suggestion: String?) =
        "Say where the pen goes: \"pen down\" or \"pen up\".${didYouMean(suggestion)}"

    override fun missingTimes(count: String, suggestion: String?) =
        "After ${quoted("repeat $count")} comes \"times\".${didYouMean(suggestion)}"

    override fun missingTimeUnit(duration: String) =
        "Say how long: ${quoted("wait $duration seconds")} or ${quoted("wait $duration milliseconds")}."

    override fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?) =
        "${quoted(command)} measures in ${units.joinToString(" or ")}, not in ${quoted(unit)}.${didYouMean(suggestion)}"

    override fun severalCommands(second: String) = "Write ${quoted(second)} on a line of its own."

    override fun extraWords(extra: String, complete: String) =
        "The line is complete after ${quoted(complete)}, so ${quoted(extra)} has no place here."

    override fun missingEnd(block: String) =
        "This ${quoted(block)} has no \"end\". Write \"end\" on a line of its own where the block stops."

    override fun extraEnd() = "This \"end\" has no block to close."

    override fun unknownCharacter(character: String) = "The character ${quoted(character)} has no meaning here."

    override fun invisibleCharacter(code: String) = "There is a character here that cannot be seen ($code). Delete it."

    override fun characterInsteadOf(written: String, right: String) = writeInstead(written, right)

    override fun commentBegins() = "A comment begins with \"//\"."

    override fun semicolon() = "A line needs no semicolon."

    override fun numberTooLarge(smallest: Int, largest: Int) =
        "This number is too large. Numbers go from $smallest to $largest."

    override fun malformedNumber(number: String, right: String?) =
        if (right == null) "${quoted(number)} is not a number." else writeInstead(number, right)

    override fun decimalComma(right: String?) =
        if (right == null) "A number has a point, not a comma." else "A number has a point, not a comma. Write $right."

    override fun nestedTooDeeply(limit: Int) = "There can be at most $limit blocks inside each other."

    override fun sourceTooLong(limit: Int) = "A program can have at most $limit characters. This one has more."

    override fun unclosedText() = "A text ends with a quotation mark."

    override fun useTwoEqualsSigns() = "Use \"==\" to compare."

    override fun useOneEqualsSign() = "Use \"=\" to give a variable its value."

    override fun combinedAssignment(name: String, operator: String) =
        "Write ${quoted("$name = $name $operator ...")} instead."

    override fun missingCondition(command: String, example: String) =
        "After ${quoted(command)} comes a condition, such as ${quoted(example)}."

    override fun missingValue(command: String, example: String) =
        "After ${quoted(command)} comes a value, such as ${quoted(example)}."

    override fun missingOperand(before: String) = "After ${quoted(before)} a value is missing."

    override fun missingAssignment(before: String, example: String) =
        "After ${quoted(before)} comes \"=\" and a value, such as ${quoted(example)}."

    override fun missingName(before: String, example: String) =
        "After ${quoted(before)} comes a name, such as ${quoted(example)}."

    override fun reservedWord(word: String) = "${quoted(word)} is a word of Robolang. Take another name."

    override fun missingBracket(opening: String, closing: String) = "This ${quoted(opening)} has no ${quoted(closing)}."

    override fun missingBracketsOfCall(name: String) =
        "To call ${quoted(name)}, write its values in brackets behind it, or empty brackets if it has none."

    override fun missingBracketsOfRoutine(name: String) =
        "After ${quoted(name)} come brackets, with the names of its values between them, or empty."

    override fun missingWord(before: String, word: String, suggestion: String?) =
        "After ${quoted(before)} comes ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingButton(suggestion: String?) =
        "Say which button: \"button run\", \"button view\" or \"button prgm\".${didYouMean(suggestion)}"

    override fun missingMove(suggestion: String?) =
        "Say what to start: \"start forward\", \"start backward\" or \"start turning left\".${didYouMean(suggestion)}"

    override fun missingMotor() = "Say which motor: A, B or C."

    override fun missingMotorCommand(motor: String, suggestion: String?) =
        "Say what motor $motor does: forward, backward, stop, float or power.${didYouMean(suggestion)}"

    override fun missingFacing(suggestion: String?) =
        "Say where the light sensor looks: \"facing down\" or \"facing forward\".${didYouMean(suggestion)}"

    override fun portOutOfRange() = "The sensors are 1, 2 and 3, such as \"sensor 2\"."

    override fun lengthAndTime() = "Say how far or how long, not both."

    override fun extraElse() = "This \"else\" has no \"if\"."

    override fun notOutermost(word: String) = "A ${quoted(word)} cannot be inside another block. Move it out."

    override fun secondRobot() = "There is a \"robot\" already. A program has only one."

    override fun unknownSetting() =
        "Between \"robot\" and \"end\" stands only the light sensor, such as \"light sensor on 2 facing down\"."

    override fun secondSetting() = "The light sensor is set already."

    override fun expressionTooDeep(limit: Int) =
        "There can be at most $limit brackets and operators inside each other. Use a variable for a part."

    override fun valueAsCommand(word: String) =
        "${quoted(word)} has a value but does nothing. Use it inside a command, such as \"show light\"."

    override fun settingOutsideRobot() = "This belongs between a line \"robot\" and its \"end\"."

    override fun colon() = "A line needs no colon."

    override fun brace(brace: String) = "A block needs no ${quoted(brace)}. It stops at a line \"end\"."

    override fun malformedName(name: String) =
        "${quoted(name)} is no name. A name begins with a letter and has letters, figures and \"_\"."

    override fun missingComma(second: String) = "Put a comma before ${quoted(second)}."

    override fun textAsValue(text: String) = "A text such as $text can only be shown, with \"show\"."
}
