package robotran.nqc.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted
import robotran.nqc.config.ParameterLimit

/** The messages in English. */
object EnglishNqcMessages :
    NqcMessages,
    DirectiveMessages by EnglishDirectiveMessages,
    NqcSyntaxMessages by EnglishSyntaxMessages,
    NqcNameMessages by EnglishNameMessages,
    NqcCodeMessages by EnglishCodeMessages

private object EnglishDirectiveMessages : DirectiveMessages {
    override fun fileNotFound(name: String) = "There is no file ${quoted(name)} in this program."

    override fun includeNeedsName() = "After #include comes the name of a file in quotation marks: #include \"my.nqh\"."

    override fun tooManyIncludes() = "Too many files include each other. Does a file include itself?"

    override fun directiveNeedsName(directive: String) = "After #$directive comes a name, for example \"SPEED\"."

    override fun macroRedefined(name: String) =
        "${quoted(name)} is defined already. Choose another name, or write #undef $name first."

    override fun macroParameters(name: String) =
        "After ${quoted(name)} comes a blank, or the parameters in brackets: #define $name(a, b)."

    override fun signInDefinition(sign: String, name: String) = if (sign == ";") {
        "The line of a #define ends without a semicolon. This one gets into every line with $name."
    } else {
        "Between $name and its value there is no $sign in a #define."
    }

    override fun macroCircular(name: String) =
        "${quoted(name)} is defined by itself, so it never becomes a value. Check its #define."

    override fun macroArguments(name: String, count: Int) = when (count) {
        0 -> "${quoted(name)} needs empty brackets: $name()."
        1 -> "${quoted(name)} needs one argument in brackets: $name(1)."
        else -> "${quoted(name)} needs $count arguments in brackets, with commas between them."
    }

    override fun macrosTooLong(name: String) =
        "The definitions around ${quoted(name)} make the program far too long. Use fewer of them in each other."

    override fun unterminatedIf() = "This #if has no end. Write #endif where it stops."

    override fun elseWithoutIf(directive: String) = "This #$directive has no #if before it."

    override fun unknownDirective(directive: String) = if (directive.isEmpty()) {
        "After # comes a word such as \"define\"."
    } else {
        "There is no #$directive. NQC knows #define, #undef, #include, #if, #ifdef, #else, #endif and #pragma."
    }

    override fun conditionSyntax() =
        "This condition cannot be computed. It may have numbers, names, defined(NAME) and operators."

    override fun conditionIncomplete() = "The condition ends too early: a number or a name is missing."

    override fun conditionBrackets() = "The brackets of this condition do not fit together."

    override fun unterminatedComment() = "This comment has no end. Write */ where it stops."

    override fun errorDirective(text: String) = "The program itself says that something is wrong here: ${text.ifEmpty {
        "#error"
    }}"

    override fun warningDirective(text: String) = "The program itself warns: ${text.ifEmpty { "#warning" }}"

    override fun unknownPragma(word: String) = if (word.isEmpty()) {
        "After #pragma comes \"noinit\", \"init\" with a function, or \"reserve\" with numbers."
    } else {
        "NQC ignores the #pragma ${quoted(word)}. It knows noinit, init with a function, and reserve with numbers."
    }

    override fun notReserved(last: Int) =
        "These variables cannot be reserved. The numbers go from 0 to $last, and each can be reserved only once."
}

private object EnglishSyntaxMessages : NqcSyntaxMessages {
    override fun unexpected(text: String) = "${quoted(text)} does not fit here. Is something before it missing?"

    override fun unexpectedEnd() = "The program ends too early."

    override fun unknownCharacter(character: String) = "The character ${quoted(character)} means nothing here."

    override fun pastedCharacter(pasted: PastedCharacter, written: String) = pasted.adviceIn(Language.ENGLISH, written)

    override fun decimalNumber() =
        "The brick computes with whole numbers only. Count in smaller steps instead, such as tenths or hundredths."

    override fun decimalTime(seconds: String, hundredths: Int) =
        "NQC has no decimals and counts time in hundredths of a second: write $hundredths for $seconds seconds."

    override fun misspelledWord(typed: String, meant: String, isCase: Boolean) =
        "${quoted(typed)} is no word of NQC. Did you mean ${quoted(meant)}?" +
            if (isCase) " Capital letters matter." else ""

    override fun otherType(type: String) = "NQC has no $type, only whole numbers: int."

    override fun textAsValue() = "The brick cannot show texts, so NQC has none. Use a number."

    override fun quotedName(name: String) = "Write $name without quotation marks."

    override fun nestedUnit(name: String) =
        "${quoted(name)} cannot be inside of a task, sub or function. Move it out, above or below."

    override fun mainFunction(right: String) = "The main task begins like this: $right"

    override fun taskWithBrackets(command: String, task: String) =
        "After $command comes the name of the task without brackets: $command $task;"

    override fun taskCommand(written: String, right: String) = "${quoted(written)} is no command of NQC. Write: $right;"

    override fun taskParameters(name: String) =
        "A task takes nothing in its brackets: task $name(). Use a global variable instead."

    override fun constantVariable(right: String) = "Only parameters are const in NQC. Write: $right"

    override fun extraWord(word: String) = "NQC has no ${quoted(word)}. Leave this word out."

    override fun missingSemicolon() = "A semicolon is missing here."

    override fun missing(sign: String) = "A ${quoted(sign)} is missing here."

    override fun missingBrace(line: Int) = "The block that begins in line $line has no end. Write } where it stops."

    override fun extraBrace() = "This } closes nothing."

    override fun missingValue(before: String) = "After ${quoted(before)} a value is missing."

    override fun missingName(before: String, word: String?) = if (word == null) {
        "After ${quoted(before)} a name is missing."
    } else {
        "${quoted(word)} is a word of NQC, so it cannot be a name. Choose another one."
    }

    override fun missingBlock(before: String) = "After ${quoted(before)} comes a block in braces: { }."

    override fun missingColon(word: String) = "The colon that belongs to ${quoted(word)} is missing."

    override fun callAsValue(name: String) =
        "${quoted(name)} does something, but it gives no value. Write it as a line of its own."

    override fun assignmentAsValue() = "One = assigns. To compare, write two: ==."

    override fun secondChoice() = "Put the second choice with ? in brackets."

    override fun returnWithValue() = "A function in NQC gives no value. Write only: return;"

    override fun functionWithType(name: String) =
        "A function in NQC gives no value, so it begins with void: void $name(). It can change global variables."

    override fun inlineWritten() = "All functions of NQC are inline already. Leave this word out."

    override fun catchAlone() = "This catch has no monitor or acquire with a block right before it."

    override fun elseAlone() = "This else has no if right before it. Two lines after an if need braces."

    override fun doWithoutWhile() = "After the body of do comes: while (condition);"

    override fun declarationInFor() = "Declare the variable before the loop: int i; for (i = 0; i < 3; i++)."

    override fun statementAfterLabel() = "Before } a command is missing; a single semicolon will do."

    override fun outsideTask(text: String) =
        "${quoted(text)} must be inside of a task, a sub or a function. A program begins with task main()."

    override fun parameterNeedsType(text: String) =
        "A parameter begins with int, const int or __sensor, not with ${quoted(text)}."

    override fun resourceWritten() = "__res is for Spybots; an RCX has nothing like it."

    override fun sourceTooLong(limit: Int) = "The file is too long. At most $limit characters are possible."

    override fun programTooLong() = "The program is far too long for a brick."

    override fun nestedTooDeeply(limit: Int) =
        "Too much is inside of each other here. At most $limit levels are possible."

    override fun numberTooLarge() = "This number is far too large. The brick computes with -32768 to 32767."

    override fun noEffect() = "This line does nothing. Did you mean to assign with = or to call a function?"

    override fun emptyBody(word: String) =
        "This semicolon ends the $word, so what follows does not belong to it. Remove it."

    override fun misleadingIndent(word: String) =
        "This line does not belong to the $word: without braces, only one does. Put { } around both."
}

private object EnglishNameMessages : NqcNameMessages {
    override fun mainMissing(suggestion: String?) = if (suggestion == null) {
        "The program has no main task. It begins with: task main() { }"
    } else {
        "The task that starts the program must be named main, not $suggestion."
    }

    override fun redeclared(name: String, line: Int?) = if (line == null) {
        "${quoted(name)} is a name of NQC itself. Choose another one."
    } else {
        "${quoted(name)} is declared already, in line $line. Choose another name."
    }

    override fun undefinedVariable(name: String, suggestion: String?) =
        "There is no variable ${quoted(name)}. ${didYouMean(suggestion) ?: "Declare it first: int $name;"}"

    override fun notOfSeries(name: String, others: List<String>) =
        "There is no ${quoted(name)}. There are: ${others.joinToString()}"

    override fun sensorByName(right: String) = "A sensor is read by its name alone: $right"

    override fun undefinedCommand(name: String, suggestion: String?) = "There is nothing named ${quoted(name)}. " +
        (didYouMean(suggestion) ?: "A command looks like this: OnFwd(OUT_A);")

    override fun bracketsMissing(name: String, call: String) = "After ${quoted(name)} come brackets: $call;"

    override fun undefinedFunction(name: String, suggestion: String?) =
        "There is no function ${quoted(name)}. ${didYouMean(suggestion) ?: "Check how it is spelled."}"

    override fun undefinedTask(name: String, suggestion: String?) =
        "There is no task ${quoted(name)}. ${didYouMean(suggestion) ?: "Write it: task $name() { }"}"

    override fun taskCalled(name: String) = "${quoted(name)} is a task. Write: start $name;"

    override fun needsSecondFirmware(name: String) =
        "${quoted(name)} needs firmware 2.0. This program is for firmware 1.0 (target RCX)."

    override fun taskNeverStarted(name: String) = "Nothing starts the task ${quoted(name)}. Write: start $name;"

    override fun undefinedLabel(name: String) =
        "There is no label ${quoted(name)} here. It must be in the same task, sub or function: $name:"

    override fun labelRedefined(name: String) = "The label ${quoted(name)} is there twice. Choose another name."

    override fun initUndefined(name: String) =
        "#pragma init names ${quoted(name)}, but there is no function of that name."

    override fun isArray(name: String) = "${quoted(name)} is an array. Say which element: $name[0]."

    override fun isNotArray(name: String) = "${quoted(name)} is no array, so it has no elements. Leave [ ] out."

    override fun isNotPointer(name: String) = "${quoted(name)} is no pointer. Declare it with a star: int *$name;"

    override fun arrayInitialized(name: String) =
        "An array cannot get a value when it is declared. Assign to its elements: $name[0] = 1;"

    override fun argumentCount(name: String, needed: Int, given: Int, call: String) = when (needed) {
        0 -> "${quoted(name)} takes nothing in its brackets: $name()."
        1 -> "${quoted(name)} takes one argument, but here are $given. Write it like this: $call;"

        else -> "${quoted(name)} takes $needed arguments, but here ${if (given == 1) "is 1" else "are $given"}. " +
            "Write it like this: $call;"
    }

    override fun argumentNotConstant() = "This must be a constant: a number or a name such as OUT_A, not a variable."

    override fun argumentNotVariable() = "This must be a variable, because the function changes it."

    override fun argumentNotSensor() = "This must be a sensor: SENSOR_1, SENSOR_2 or SENSOR_3."

    override fun argumentNotPointer() = "This must be a pointer, or the address of a variable: &name."

    override fun nestedSub(name: String) =
        "A sub cannot call a sub, and ${quoted(name)} leads to one. Make it a function: void $name()."

    override fun recursion(name: String) = "${quoted(name)} calls itself. A brick cannot do that. Use a loop."

    override fun subParameters(target: String) =
        "A sub takes nothing in its brackets on $target. Use a global variable, or make it a function: void."

    override fun tooManyTasks(limit: Int) = "A brick has room for $limit tasks. This is one too many."

    override fun tooManySubs(limit: Int) =
        "A brick has room for $limit subs. This is one too many. Make some of them functions: void."

    override fun pointerUnsupported() = "Pointers need firmware 2.0. This program is for firmware 1.0 (target RCX)."

    override fun arrayUnsupported() = "Arrays need firmware 2.0. This program is for firmware 1.0 (target RCX)."

    override fun acquireUnsupported() = "acquire needs firmware 2.0. This program is for firmware 1.0 (target RCX)."

    override fun monitorUnsupported() = "monitor needs firmware 2.0. This program is for firmware 1.0 (target RCX)."

    private fun didYouMean(suggestion: String?) = suggestion?.let { "Did you mean ${quoted(it)}?" }
}

private object EnglishCodeMessages : NqcCodeMessages {
    override fun noStorage() =
        "The brick has no room for this variable. It has 32 for all tasks, and 16 more for each with firmware 2.0."

    override fun noStorageInSharedSub() =
        "Several tasks call this sub, so its variables need places of their own in each: 16 with firmware 2.0, none " +
            "with 1.0."

    override fun noStorageForSub(name: String) =
        "The variables of ${quoted(name)} and of this task together do not fit into the brick. Use fewer of them."

    override fun noTemporaries() =
        "The brick has no variables left to compute this. Use fewer variables, or split the line."

    override fun constantNeeded() = "This must be a constant: a number, or a name that #define gives one."

    override fun shiftNeedsConstant() = "By how many bits << and >> shift must be a constant."

    override fun numberOutOfRange(number: Int) = "$number is too large for the brick. Numbers go from -32768 to 32767."

    override fun numberCut(number: Int, kept: Int) = "$number is too large for the brick. It becomes $kept."

    override fun caseOutOfRange() = "A case can be -32768 to 32767."

    override fun notAssignable() = "Nothing can be assigned to this. On the left of = comes a variable."

    override fun notSteppable() = "Only a variable can be changed with ++ or --. Write x = x + 1; instead."

    override fun wrongSource() = "This command cannot take such a value. Assign it to a variable first."

    override fun nestedAcquire() = "An acquire cannot be inside of another one. Put both into one: acquire(A | B)."

    override fun nestedMonitor() = "A monitor cannot be inside of another one. Put both into one: monitor(A | B)."

    override fun continueOutsideLoop() = "continue goes on with the next round of a loop, but here is no loop."

    override fun breakOutsideLoop() = "break leaves a loop or a switch, but here is none."

    override fun caseOutsideSwitch() = "case and default belong into a switch."

    override fun duplicateCase(value: Int?) =
        if (value == null) "This switch has a default already." else "This switch has a case $value already."

    override fun wrongEventSource() =
        "Events come from SENSOR_1 to SENSOR_3, Timer(0) to Timer(3), Counter(0) to Counter(2), or Message()."

    override fun taskNumberUnknown() = "Several tasks call this sub, so __taskid could be any of them."

    override fun addressNotConstant() = "For & the number of the element must be a constant."

    override fun dividedByZero(isError: Boolean, isModulo: Boolean) = when {
        isError -> "A number cannot be divided by 0."
        isModulo -> "This divides by 0. The brick then leaves out the division, so the result makes no sense."
        else -> "This divides by 0. The brick then leaves out the division."
    }

    override fun wrongArraySize(limit: Int) = "An array has 1 to $limit elements."

    override fun indexOutside(name: String, last: Int) =
        "${quoted(name)} has elements 0 to $last. This one belongs to another variable."

    override fun codeTooLong(limit: Int) =
        "The code becomes longer than $limit bytes. A brick has about 6000. Turn functions into subs."

    override fun memoryFull(bytes: Int, limit: Int) =
        "The program has $bytes bytes, but a brick has only $limit for all programs. Turn functions into subs."

    override fun sensorNotSet(port: Int, call: String) =
        "Nothing says what is connected to port $port. Write at the beginning: $call;"

    override fun argumentRange(limit: ParameterLimit, value: Int) =
        "${nounOf(limit)} goes from ${limit.values.first} to ${limit.values.last}, but this is $value."

    private fun nounOf(limit: ParameterLimit) = when (limit) {
        ParameterLimit.OUTPUTS -> "A sum of OUT_A, OUT_B and OUT_C"
        ParameterLimit.POWER -> "Power"
        ParameterLimit.SOUND -> "The number of a sound"
        ParameterLimit.FREQUENCY -> "A frequency"
        ParameterLimit.TONE_TIME -> "The length of a tone"
        ParameterLimit.TIMER -> "The number of a timer"
        ParameterLimit.COUNTER -> "The number of a counter"
        ParameterLimit.EVENT -> "The number of an event"
        ParameterLimit.MESSAGE -> "A message"
        ParameterLimit.PROGRAM -> "The number of a program"
        ParameterLimit.PRIORITY -> "A priority"
        ParameterLimit.HOUR -> "An hour"
        ParameterLimit.MINUTE -> "A minute"
        ParameterLimit.SLEEP_TIME -> "The time until the brick sleeps"
        ParameterLimit.WAIT -> "A time to wait"
        ParameterLimit.DISPLAY -> "A view of the display"
        ParameterLimit.DECIMALS -> "The number of decimal places"
        ParameterLimit.SENSOR_TYPE -> "A type of sensors"
        ParameterLimit.ENTRIES -> "A number of entries"
    }
}
