package robotran.robolang.messages

import robotran.language.quoted

/** What is told in English about lines that make no sense. */
internal object EnglishMeaningMessages : MeaningMessages {
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

    override fun notComparable() = "Only two numbers or two conditions can be compared."

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
