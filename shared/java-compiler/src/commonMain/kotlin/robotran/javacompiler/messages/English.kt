package robotran.javacompiler.messages

import robotran.language.quoted
import robotran.lejoslibrary.LejosRemedy

object EnglishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by EnglishJavaSyntaxMessages,
    JavaNameMessages by EnglishJavaNameMessages,
    JavaSemanticMessages by EnglishJavaSemanticMessages,
    JavaClassMessages by EnglishJavaClassMessages,
    UnsupportedOnBrickMessages by EnglishBrickMessages,
    LejosMessages by EnglishLejosMessages

private object EnglishJavaSyntaxMessages : JavaSyntaxMessages {
    override fun missingSemicolon() = "Put a \";\" at the end of this statement."

    override fun missingBracket(bracket: String) =
        "There is a ${quoted(openingOf(bracket))} without its ${quoted(bracket)}."

    override fun extraBracket(bracket: String) =
        "This ${quoted(bracket)} is one too many, or something before it is missing."

    override fun expectedInstead(word: String, expected: String) =
        "Java expects ${quoted(expected)} here, not ${quoted(word)}."

    override fun expectedAfter(word: String, expected: String) =
        "Java expects ${quoted(expected)} after ${quoted(word)}."

    override fun notUnderstood(word: String) = "Java cannot make sense of ${quoted(word)} here."

    override fun somethingMissing(word: String) = "Something is missing after ${quoted(word)}."

    override fun compilerSays(english: String) = english

    override fun unclosedString() = "This text has no closing quotation mark."

    override fun closeString() = "Put a quotation mark behind its last letter. A text cannot go on in the next line."

    override fun wrongCharacter() =
        "Between single quotation marks stands exactly one character. A text has double ones."

    override fun foreignWord(word: String, javaWord: String) = "Java says ${quoted(javaWord)} for ${quoted(word)}."

    override fun noSuchWord(word: String) = "Java has no ${quoted(word)}. Leave it away."

    override fun conditionInBrackets(word: String) =
        "What comes after ${quoted(word)} stands in brackets, as in: ${exampleOf(word)}"

    override fun semicolonsInFor() = "The three parts of a \"for\" have \";\" between them: for (int i = 0; i < 4; i++)"

    override fun elseWithoutIf() =
        "There is no \"if\" for this \"else\". Look for a \";\" right after the \"if\", or for a missing \"{\" or " +
            "\"}\"."

    override fun outsideMethod() = "This statement is in a class, but in none of its methods."

    override fun moveIntoMethod() = "Move it between the braces of a method, such as main."

    override fun outsideClass() = "This is in no class, and in Java everything is in one."

    override fun beginWithClass(className: String) =
        "Begin with: public class $className { public static void main(String[] args) { and end with: } }"

    override fun callWithBrackets(name: String) = "To call the method ${quoted(name)}, put brackets behind it: $name()"

    override fun noStatement() = "This works something out, and nothing happens with it."

    override fun setWithOneSign() = "Two signs compare. To set a variable, write a single \"=\"."

    override fun reservedWord(word: String) =
        "${quoted(word)} is a word of Java's own, so nothing can be called that. Take another name."

    override fun nameBeginsWithLetter() = "A name begins with a letter, not with a digit."

    override fun typeOfParameter() =
        "Between the brackets of a method, each name has its type before it, as in: (int speed)"

    override fun lengthOfArray() = "An array gets its length where it is made: int[] values = new int[3];"

    override fun arrayOfValues() = "Write what is made before the braces: new int[] {1, 2, 3}"

    override fun tryAlone() = "This \"try\" has no \"catch\"."

    override fun addCatch() = "Write after its \"}\": catch (InterruptedException e) { }"

    override fun sourceTooLong(limit: String) =
        "A program can have at most $limit characters and 100 files. Nothing of it was read."

    override fun nestedTooDeeply() = "Too much is inside each other here. Use a method or a variable for a part."

    override fun compilerFailed() =
        "The compiler gave up on this program. Take away what you changed last, and try again."
}

private object EnglishJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "There is no class ${quoted(name)}."

    override fun unknownVariable(name: String) = "There is no variable ${quoted(name)}."

    override fun unknownMethod(name: String, owner: String) = "${quoted(owner)} has no method ${quoted(name)}."

    override fun unknownMethodHere(name: String, owner: String) =
        "${quoted(owner)} has no method ${quoted(name)}, and no class stands before it."

    override fun unknownField(name: String, owner: String?) =
        if (owner == null) "There is no ${quoted(name)} here." else "${quoted(owner)} has no ${quoted(name)}."

    override fun unknownImport(name: String) = "The brick has no ${quoted(name)}."

    override fun didYouMean(suggestion: String) = "Did you mean ${quoted(suggestion)}?"

    override fun wrongCase(suggestion: String) =
        "Write ${quoted(suggestion)}: Java tells small letters from capital ones."

    override fun importIt(line: String) = "Write ${quoted(line)} at the top."

    override fun declareIt(name: String) = "Declare it first, such as with \"int $name = 0;\"."

    override fun writeMethod(name: String) = "Write the method: static void $name() { }"

    override fun isPrivate(name: String, owner: String) =
        "${quoted(name)} is private: only ${quoted(owner)} itself may use it."

    override fun usePublic() = "Take \"private\" away where it is declared, or use a method that its class has for it."

    override fun lengthOfArrayValue() = "The length of an array has no brackets: values.length"

    override fun lengthOfTextOrArray() =
        "The length of a text has brackets, word.length(), and that of an array has none, values.length."

    override fun noArray(type: String) = "Only an array has \"[...]\" behind it, and this is a ${quoted(type)}."

    override fun charAt() = "A letter of a text is word.charAt(0), the first one having the number 0."

    override fun noMembers(type: String) = "This is of type ${quoted(type)}, a single value, and has no methods."
}

private object EnglishJavaSemanticMessages : JavaSemanticMessages {
    override fun doesNotFit(given: String, needed: String) =
        "This is of type ${quoted(given)}, and ${quoted(needed)} is needed here."

    override fun castNumber(type: String) =
        "Write \"($type)\" before it, with brackets around it, if a part of it may get lost."

    override fun castObject(type: String) = "Write \"($type)\" before it, if you know that it is one."

    override fun writeFloat(number: String) = "Write \"${number}f\"."

    override fun compareWithTwoSigns() = "To compare, write \"==\". A single \"=\" sets a variable."

    override fun compareWithZero() = "A condition is true or false. Compare the number with something, as in: count > 0"

    override fun makeText() = "Integer.toString(...) around a whole number makes it a text."

    override fun givesNothing() = "This method is \"void\", so it gives nothing back that could be used here."

    override fun notInitialized(name: String) =
        "${quoted(name)} may have no value yet. Give it one where it is declared."

    override fun declaredTwice(name: String) =
        "${quoted(name)} is declared already. Take another name, or leave its type away to set it."

    override fun returnsNothing() =
        "This method is \"void\", so it gives nothing back. Write \"return;\" or change its type."

    override fun mustReturn() = "This method has to give a value back on every way through it."

    override fun returnValue() =
        "Write \"return\" and the value, also for the case that no \"if\" is true. If there is none to give, make it " +
            "\"void\"."

    override fun neverReached() = "The program never gets here, because of what stands before it."

    override fun unhandledException(name: String) = "${quoted(name)} can happen here, and nothing takes care of it."

    override fun handleIt(name: String) =
        "Write \"throws $name\" behind the brackets of the method, as in \"main(String[] args) throws $name\", or " +
            "put it into " +
            "try { ... } catch ($name e) { }, as a method \"run\" must."

    override fun neverThrown(name: String) =
        "Nothing in the \"try\" can lead to this ${quoted(name)}, or a \"catch\" before has taken it."

    override fun removeCatch() = "Take this \"catch\" away."

    override fun wrongArguments(method: String, needed: String, given: String) =
        "${quoted(method)} takes ${inBrackets(needed)}, not ${inBrackets(given)}."

    override fun staticNeeded(name: String) =
        "${quoted(name)} belongs to an object, and in a \"static\" method there is none."

    override fun makeItStatic() = "Write \"static\" before it where it is declared."

    override fun objectNeeded(name: String, owner: String) =
        "${quoted(name)} needs an object of ${quoted(owner)}, not the class."

    override fun neverChanges(name: String) = "${quoted(name)} is \"final\", so it can be set only once."

    override fun numberTooLarge(number: String) =
        "$number is too large. An \"int\" goes from -2147483648 to 2147483647."

    override fun noEffect() = "This changes nothing."

    override fun emptyStatement() = "This \";\" is all that is done here. Take it away if a block comes next."

    override fun wrongOperator(operator: String, types: String) =
        "${quoted(operator)} does not work with ${quoted(types)}."

    private fun inBrackets(types: String) = if (types.isEmpty()) "no values" else "($types)"
}

private object EnglishJavaClassMessages : JavaClassMessages {
    override fun wrongFileName(className: String) =
        "A public class is in a file of its own name. Call the file ${quoted("$className.java")}, or the class like " +
            "the file."

    override fun missingReturnType() = "This method says no type of what it gives back."

    override fun writeVoid() = "Write \"void\" before its name, if it gives nothing back."

    override fun cannotInstantiate(name: String) =
        "Java cannot make a ${quoted(name)} with \"new\", because a part of it is still to be written."

    override fun extendThread() =
        "Write a class that \"extends Thread\" and has a method \"public void run()\", and make one of those. A " +
            "brick's Thread takes no Runnable."

    override fun extendIt(name: String) =
        "Write a class that is a $name and has all its methods, and make one of those."

    override fun mustHaveMethod(className: String, method: String, owner: String) =
        "${quoted(className)} is a ${quoted(owner)}, so it must have the method ${quoted(method)}."

    override fun writePublicMethod(method: String) =
        "Write it with \"public\" before it, such as: public void $method { }"

    override fun mustBePublic(method: String) = "${quoted(method)} must have \"public\" before it."

    override fun noMain() = "The brick does not know where to begin: no class has a method \"main\"."

    override fun wrongMain() =
        "The brick does not know where to begin, because this method is not declared as \"main\" must be."

    override fun writeMain() = "Write it like this: public static void main(String[] args) { }"
}

private object EnglishBrickMessages : UnsupportedOnBrickMessages {
    override fun newerJava(what: NewerJava) = "The brick's Java is older and has no ${name(what)}."

    override fun insteadOf(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> {
            "Leave the \"<...>\" away. When you take something out, write its type before it: (String) " +
                "list.elementAt(0)."
        }

        NewerJava.FOR_EACH -> {
            "Count instead: for (int i = 0; i < values.length; i++)."
        }

        NewerJava.VARARGS -> {
            "Use an array, such as int[]."
        }

        NewerJava.ANNOTATION -> {
            "Leave it away."
        }

        NewerJava.ENUM -> {
            "Use numbers with names: static final int RED = 0, GREEN = 1;"
        }

        NewerJava.STATIC_IMPORT -> {
            "Import the class, and write its name before the method."
        }

        NewerJava.INTERFACE_METHOD_BODY -> {
            "Write the method in a class."
        }

        NewerJava.LAMBDA -> {
            "Write a class for it, such as new Thread() { public void run() { ... } }."
        }

        NewerJava.MULTI_CATCH -> {
            "Write a \"catch\" for each."
        }

        NewerJava.TRY_WITH_RESOURCES -> {
            "Write the statement before the \"try\"."
        }

        NewerJava.SWITCH_EXPRESSION -> {
            "Use \"if\" and \"else\"."
        }

        NewerJava.AUTOBOXING -> {
            "Use \"int\", or \"new Integer(...)\" to put a number into a Vector."
        }

        NewerJava.ASSERT -> {
            "Use \"if\"."
        }

        NewerJava.VAR -> {
            "Write the type, such as \"int\"."
        }

        NewerJava.TEXT_BLOCK -> {
            "Write a text between two quotation marks, on one line."
        }

        NewerJava.NUMBER_STYLE -> {
            "Write the number with digits only."
        }
    }

    private fun name(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> "types in \"<...>\""
        NewerJava.FOR_EACH -> "\"for\" with a colon"
        NewerJava.VARARGS -> "\"...\" in a method"
        NewerJava.ANNOTATION -> "annotations with \"@\""
        NewerJava.ENUM -> "\"enum\""
        NewerJava.STATIC_IMPORT -> "\"import static\""
        NewerJava.INTERFACE_METHOD_BODY -> "method bodies in an interface"
        NewerJava.LAMBDA -> "\"->\" or \"::\""
        NewerJava.MULTI_CATCH -> "\"|\" in a \"catch\""
        NewerJava.TRY_WITH_RESOURCES -> "brackets after \"try\""
        NewerJava.SWITCH_EXPRESSION -> "\"switch\" with a value"
        NewerJava.AUTOBOXING -> "way from a number to an object by itself"
        NewerJava.ASSERT -> "\"assert\""
        NewerJava.VAR -> "\"var\""
        NewerJava.TEXT_BLOCK -> "texts between three quotation marks"
        NewerJava.NUMBER_STYLE -> "\"_\" in numbers, and no numbers that begin with \"0b\""
    }

    override fun absent(what: UnsupportedOnBrick) = when (what) {
        UnsupportedOnBrick.PRINTING -> {
            "The brick shows numbers with LCD.showNumber(7) and up to five letters with TextLCD.print(\"hello\")."
        }

        UnsupportedOnBrick.KEYBOARD -> {
            "The brick has no keyboard. Ask its buttons, such as Button.VIEW.isPressed()."
        }

        UnsupportedOnBrick.COLLECTIONS -> {
            "Use an array, such as int[], or a Vector from java.util."
        }

        UnsupportedOnBrick.VECTOR_METHODS -> {
            "A brick's Vector has addElement(), elementAt(), setElementAt(), removeElementAt() and size()."
        }

        UnsupportedOnBrick.HASHTABLE_METHODS -> {
            "A Hashtable on the brick has put() and get(), and get() gives null for what is not in it."
        }

        UnsupportedOnBrick.RUNNABLE -> {
            "Write \"extends Thread\" instead, with a method \"public void run()\"."
        }

        UnsupportedOnBrick.FORMATTING -> {
            "The brick cannot format texts. Show a number with LCD.showNumber(7)."
        }

        UnsupportedOnBrick.TEXT_METHODS -> {
            "A text on the brick has length(), charAt(), toCharArray() and equals(), and little more."
        }

        UnsupportedOnBrick.PARSING -> {
            "The brick cannot read numbers from texts."
        }

        UnsupportedOnBrick.WRAPPERS -> {
            "Use boolean, char, int or float itself."
        }

        UnsupportedOnBrick.WRITING_NUMBERS -> {
            "Integer.toString(number) makes a text of a whole number. LCD.showNumber(number) shows it without one."
        }

        UnsupportedOnBrick.SYSTEM_METHODS -> {
            "System.currentTimeMillis() is the time, and memory is never taken back."
        }

        UnsupportedOnBrick.ARRAY_COPYING -> {
            "Copy one element after the other in a \"for\"."
        }

        UnsupportedOnBrick.WAITING -> {
            "Thread.sleep(1000) waits a second."
        }

        UnsupportedOnBrick.FILES -> {
            "The brick has no files."
        }

        UnsupportedOnBrick.WINDOWS -> {
            "The brick has no windows. It shows numbers and short texts with LCD and TextLCD."
        }

        UnsupportedOnBrick.OTHER_BRICKS -> {
            "That is for newer bricks. The classes of this one are in josx.platform.rcx."
        }
    }

    override fun noSwitch() = "The brick's Java has no \"switch\"."

    override fun useIf() = "Use \"if\" and \"else if\"."

    override fun noLongArithmetic() = "The brick cannot calculate with \"long\"."

    override fun useInt() = "Make an \"int\" of it first, such as (int) System.currentTimeMillis()."

    override fun noFloatRemainder() = "The brick has no \"%\" for \"float\" and \"double\"."

    override fun useIntRemainder() = "Use \"int\", or take away a whole number of times what you divide by."

    override fun noArrayTypeTest() = "The brick cannot find out at run time whether something is an array."

    override fun useArrayItself() = "Give the variable the array's own type from the beginning, such as int[]."

    override fun noClassLiteral() = "The brick has no \".class\"."

    override fun useInstanceof() = "To find out what something is, use \"instanceof\"."

    override fun textJoinedInLoop() = "This makes a new text again and again, and the brick never gets its memory back."

    override fun makeTextOnce() = "Make it once, before the loop, or show numbers with LCD.showNumber."

    override fun divisorTooLarge(divisor: String, kept: String) =
        "The brick divides only by numbers from -32768 to 32767. It takes $divisor for $kept."

    override fun arrayTooLong(length: String, limit: String) =
        "An array on the brick has at most $limit elements, not $length."
}

private object EnglishLejosMessages : LejosMessages {
    override fun missingInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "On a real brick, leJOS makes every $owner without a text."
        LejosRemedy.CHECKED_EXCEPTION -> checkedInLejos(owner)
        LejosRemedy.STRING_BUFFER -> "leJOS on a real brick has no $owner."
        LejosRemedy.INTEGER_TO_STRING -> "$owner.$member of leJOS takes no whole number."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "$owner.$member of leJOS takes no decimal number."
        LejosRemedy.LAST_INDEX_OF -> "A $owner of leJOS has no ${quoted(member)}."
        LejosRemedy.SENSOR_CONSTANTS -> "$owner of leJOS has no $member."
        LejosRemedy.SERIAL_PACKETS, LejosRemedy.VECTOR -> "leJOS 2.1 has no $owner. It came with leJOS 3.0."
        LejosRemedy.LOOP_FROM_THE_END -> "A $owner of leJOS 2.1 has no ${quoted(member)}. It came with leJOS 3.0."
        LejosRemedy.LEAVE_OUT -> "A $owner of leJOS has no ${quoted(member)}."
        LejosRemedy.PACKAGE_OF_2_1 -> "leJOS 2.1 has $owner in another package."
    }

    override fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> {
            "Write \"new $owner()\", or take Exception or RuntimeException, which can have a text."
        }

        LejosRemedy.CHECKED_EXCEPTION -> {
            catchException()
        }

        LejosRemedy.STRING_BUFFER -> {
            "StringBuffer can do the same."
        }

        LejosRemedy.INTEGER_TO_STRING -> {
            "Write Integer.toString(number).toCharArray()."
        }

        LejosRemedy.APPEND_TO_STRING_BUFFER -> {
            "Write new StringBuffer(20).append(number).getChars()."
        }

        LejosRemedy.LAST_INDEX_OF -> {
            "Calculate it: stack.size() - stack.lastIndexOf(object)."
        }

        LejosRemedy.SENSOR_CONSTANTS -> {
            "Write SensorConstants.$member."
        }

        LejosRemedy.SERIAL_PACKETS -> {
            "Send a packet of two bytes with Serial.sendPacket, and receive it with Serial.readPacket."
        }

        LejosRemedy.VECTOR -> {
            "There, use a Vector with addElement, elementAt, removeElementAt and isEmpty."
        }

        LejosRemedy.LOOP_FROM_THE_END -> {
            "There, go through the elements from the last one to the first."
        }

        LejosRemedy.LEAVE_OUT -> {
            "Leave it out: it does nothing."
        }

        LejosRemedy.PACKAGE_OF_2_1 -> {
            "There, import it from josx.platform.rcx.remotecontrol."
        }
    }

    override fun builderOfCompiler() =
        "A newer compiler takes it for every \"+\" of texts. \"javac -source 1.3 -target 1.1\" of a JDK up to 8 does " +
            "not, and Robotran compiles Java sources itself."

    override fun checkedInLejos(name: String) = "On a real brick, every $name must be announced with \"throws\"."

    override fun catchException() = "Catch Exception instead."

    override fun unlockedMethod(name: String, modifier: String) =
        "A brick does not lock for a method that is ${quoted(modifier)}, so ${quoted(name)} is not synchronized there."

    override fun monitorCallFails(method: String) =
        "Unless the lock is held already, ${quoted(method)} in it ends with an IllegalMonitorStateException."

    override fun lockWithoutPrivate() = "Leave \"private\" out, or put what is in it into synchronized (this) { ... }."

    override fun lockAnObject() =
        "Give the class \"static final Object LOCK = new Object();\" and put what is in the method into " +
            "synchronized (LOCK) { ... }."

    override fun unlockedSuperCall(name: String) =
        "A brick does not lock for a call with \"super\", so ${quoted(name)} is not synchronized here."

    override fun lockThis() = "Put the call into synchronized (this) { ... }."

    override fun textAndNumber() =
        "On a real brick, a number may not fit behind a text: leJOS makes no room for it, and an exception ends the " +
            "program."

    override fun makeRoomForNumber() =
        "Show the number with LCD.showNumber, or make room: new StringBuffer(20).append(\"x\").append(7).toString()."
}
