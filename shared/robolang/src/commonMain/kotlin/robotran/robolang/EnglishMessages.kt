package robotran.robolang

/** The messages in English. */
object EnglishMessages : RobolangMessages, RunMessages by EnglishRunMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "There is no command ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingCommand() = "A line begins with a command, such as \"forward 20\"."

    override fun missingSpace(word: String, number: String) = "Put a space between ${quoted(word)} and ${quoted(number)}."

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

    override fun countNotWhole(count: String) = "A block cannot be repeated $count times. Use a whole number."

    override fun countNegative(count: String) = "A block cannot be repeated $count times. Use 0 or more."

    override fun waitNegative() = "The robot cannot wait for less than no time. Use 0 or more."

    override fun durationTooLong() = "This would take longer than a day. Use a smaller number."

    override fun nestedTooDeeply(limit: Int) = "There can be at most $limit blocks inside each other."

    override fun sourceTooLong(limit: Int) = "A program can have at most $limit characters. This one has more."

    private fun writeInstead(written: String, right: String) = "Write ${quoted(right)} instead of ${quoted(written)}."

    private fun quoted(text: String) = "\"$text\""

    private fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Did you mean ${quoted(suggestion)}?"
}
