package robotran.robolang.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted

/** The messages in English. */
object EnglishRobolangMessages :
    RobolangMessages,
    SyntaxMessages by EnglishSyntaxMessages,
    MeaningMessages by EnglishMeaningMessages,
    WarningMessages by EnglishWarningMessages,
    BrickKindMessages by EnglishBrickKindMessages,
    RunMessages by EnglishRunMessages

/** The messages about syntax errors in English. */
private object EnglishSyntaxMessages : SyntaxMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "There is no command ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingCommand() = "A line begins with a command, such as \"forward 20\"."

    override fun missingSpace(word: String, number: String) =
        "Put a space between ${quoted(word)} and ${quoted(number)}."

    override fun missingNumber(command: String, example: String) =
        "After ${quoted(command)} comes a number, such as ${quoted(example)}."

    override fun startInstead(start: String) = "To drive until something happens, write ${quoted(start)}."

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

    override fun pastedCharacter(pasted: PastedCharacter, written: String) = pasted.adviceIn(Language.ENGLISH, written)

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

    override fun lengthAndTime() = "Say how far or how long, not both."

    override fun extraElse() = "This \"else\" has no \"if\"."

    override fun notOutermost(word: String) = "A ${quoted(word)} cannot be inside another block. Move it out."

    override fun secondRobot() = "There is a \"robot\" already. A program has only one."

    override fun unknownSetting() =
        "Between \"robot\" and \"end\" stand only the brick and its sensors, such as \"light sensor on 2 facing down\"."

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

    override fun nameOfSeveralWords(right: String) = "A name is one word. Write ${quoted(right)}."

    override fun missingComma(second: String) = "Put a comma before ${quoted(second)}."

    override fun textAsValue(text: String) = "A text such as $text can only be shown, with \"show\"."
}

/** The messages about semantic errors in English. */
private object EnglishMeaningMessages : MeaningMessages {
    override fun countNotWhole(count: String) = "A block cannot be repeated $count times. Use a whole number."

    override fun countNegative(count: String) = "A block cannot be repeated $count times. Use 0 or more."

    override fun waitNegative() = "The robot cannot wait for less than no time. Use 0 or more."

    override fun durationTooLong() = "This would take longer than a day. Use a smaller number."

    override fun unknownVariable(name: String, suggestion: String?) =
        "There is no variable ${quoted(name)}.${didYouMean(suggestion)}"

    override fun unknownRoutine(name: String, suggestion: String?) =
        "There is no procedure or function ${quoted(name)}.${didYouMean(suggestion)}"

    override fun usedBeforeDeclaration(name: String, line: Int) =
        "${quoted(name)} is declared only in line $line. Move that line up."

    override fun declaredTwice(name: String, line: Int) =
        "${quoted(name)} is declared already, in line $line. Take another name."

    override fun declaredBuiltIn(name: String) = "Robolang has a function ${quoted(name)} already. Take another name."

    override fun assignedConstant(name: String) =
        "${quoted(name)} is a constant and never changes. Declare it with \"var\" if it should."

    override fun assignedLoopVariable(name: String) =
        "${quoted(name)} is counted by its \"for\" and cannot be changed here."

    override fun numberNeeded(text: String) = "A number is needed here, and ${quoted(text)} is none."

    override fun wholeNumberNeeded(text: String) =
        "A whole number is needed here, and ${quoted(text)} is a decimal one. Use \"round\"."

    override fun conditionNeeded(text: String) = "A condition is needed here, and ${quoted(text)} is none."

    override fun listNeeded(text: String) = "A list is needed here, and ${quoted(text)} is none."

    override fun valueNeeded(name: String) = "${quoted(name)} is a procedure and gives no value. Only a function does."

    override fun decimalForWhole(name: String) =
        "${quoted(name)} is declared with a whole number, so it cannot hold a decimal one. Declare it with a decimal " +
            "one, such as 0.0."

    override fun typeChanged(name: String) = "${quoted(name)} is declared with a value of another kind."

    override fun notComparable() = "Only two numbers, two conditions or two colours can be compared."

    override fun mixedList(text: String) = "A list holds numbers only, and ${quoted(text)} is none."

    override fun emptyList() = "A list needs at least one number."

    override fun listTooLong(limit: Int) = "A list can have at most $limit elements."

    override fun indexOutOfRange(last: Int) = "This list has the elements 0 to $last."

    override fun indexNegative() = "The elements of a list are counted from 0."

    override fun wrongArgumentCount(name: String, needed: Int, given: Int) =
        "${quoted(name)} takes ${values(needed)}, not $given."

    override fun functionAsCommand(name: String) =
        "${quoted(name)} gives a value. Use it, such as in \"show $name(...)\"."

    override fun outsideLoop(word: String) = "${quoted(word)} belongs inside a loop."

    override fun outsideRoutine() =
        "\"return\" belongs inside a procedure or function. To end the program, write \"halt\"."

    override fun returnWithValue(name: String) =
        "${quoted(name)} is a procedure and gives no value. Write \"function\" instead of \"procedure\" if it should."

    override fun returnWithoutValue(name: String) =
        "${quoted(name)} is a function. Say which value it gives, such as \"return 5\"."

    override fun missingReturn(name: String) =
        "${quoted(name)} is a function, but can come to its end without \"return\" and a value."

    override fun durationNegative() = "Nothing can last less than no time. Use 0 or more."

    override fun powerOutOfRange() = "The power of a motor goes from 0 to 7."

    override fun textTooLong(limit: Int) = "The display has room for $limit characters."

    override fun textNotShown(character: String) =
        "The display cannot show ${quoted(character)}. It has letters, figures, spaces, \"-\" and \"_\"."

    override fun divisionByZero() = "Nothing can be divided by 0."

    override fun stepZero() = "With a step of 0 this would never end."

    override fun tooManyVariables(limit: Int) = "The brick has room for $limit variables here. This is one more."

    override fun tooManyParameters(limit: Int) = "The brick has room for $limit values in brackets. This is one more."

    override fun tooManyConstants(limit: Int) =
        "The brick has room for $limit different large or decimal numbers and texts. This is one more."

    override fun tooManyRoutines(limit: Int) =
        "The brick has room for $limit procedures and functions. This is one more."

    override fun undeclaredVariable(name: String) =
        "There is no variable ${quoted(name)} yet. Write \"var\" before it to declare it."

    override fun calledBeforeDeclaration(routine: String, variable: String, line: Int) =
        "${quoted(routine)} uses ${quoted(variable)}, which is declared only in line $line. Move that line up."

    override fun calledInDeclaration(routine: String, variable: String) =
        "${quoted(routine)} uses ${quoted(variable)}, which gets its first value only here."

    override fun neededBeforeDeclaration(variable: String, line: Int) =
        "A \"whenever\" can need ${quoted(variable)} at once, but it is declared only in line $line. Move that line " +
            "to the top."

    override fun redeclared(name: String, line: Int) =
        "${quoted(name)} is declared already, in line $line. To change it, leave out \"var\"."

    override fun chainedComparison(right: String) = "Compare twice: ${quoted(right)}."

    private fun values(count: Int) = if (count == 1) "1 value" else "$count values"
}

/** The warnings in English. */
private object EnglishWarningMessages : WarningMessages {
    override fun unusedVariable(name: String) = "${quoted(name)} is never used."

    override fun neverReached(word: String) = "This is never done, because of the ${quoted(word)} before it."

    override fun busyLoop() = "This goes on forever without moving, waiting or sensing, and only keeps the brick busy."

    override fun fractionLost(division: String, result: Int) =
        "Dividing whole numbers gives a whole number: ${quoted(division)} is $result. Write one of them with a point " +
            "for more."

    override fun divisorTooLarge(divisor: Int, kept: Int) =
        "The brick divides only by numbers from -32768 to 32767. It takes $divisor for $kept."

    override fun listInLoop() =
        "This makes a new list again and again, and the brick never gets its memory back. Make the list once, at the " +
            "top."

    override fun divisorTakenForZero(divisor: Int) =
        "The brick divides only by numbers from -32768 to 32767. It takes $divisor for 0 and stops."

    override fun endlessRecursion(name: String) = "${quoted(name)} always calls itself, so it never comes to its end."
}

/** The messages about runtime errors in English. */
private object EnglishRunMessages : RunMessages {
    override fun divisionByZero(dividend: String) = "$dividend cannot be divided by 0."

    override fun indexOutside(index: Int, size: Int) = when (size) {
        0 -> "There is no element $index, the list is empty."
        1 -> "There is no element $index in a list of 1, only element 0."
        else -> "There is no element $index in a list of $size. They are counted from 0 to ${size - 1}."
    }

    override fun tooManyCalls(name: String, limit: Int) =
        "\"$name\" calls itself too often: a brick has no memory for more than $limit calls inside each other."

    override fun listsInUseTooLarge(limit: Int) =
        "The brick's memory is full: the lists in use have more than $limit elements."

    override fun listsTooLarge(limit: Int) =
        "The brick's memory is full: all the lists made so far have more than $limit elements, and it keeps every one."

    override fun negativeTime(value: String) = "The robot cannot take $value for a time. Use 0 or more."

    override fun negativeCount(value: Int) = "Nothing can be repeated $value times. Use 0 or more."

    override fun powerOutside(value: Int) = "A motor has no power $value, only 0 to 7."

    override fun stepOfNothing() = "With steps of 0 the loop would never get on."

    override fun rootOfNegative(value: String) = "$value has no square root, because it is less than 0."

    override fun powerOfNegative(base: String, exponent: String) =
        "There is no number that is $base to the power of $exponent."

    override fun nothingReturned(name: String) = "The function \"$name\" came to its end without a \"return\"."
}

private fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Did you mean ${quoted(suggestion)}?"

private fun writeInstead(written: String, right: String) = "Write ${quoted(right)} instead of ${quoted(written)}."
