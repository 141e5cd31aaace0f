package robotran.javacompiler.messages

internal object EnglishBrickMessages : UnsupportedOnBrickMessages {
    override fun newerJava(what: NewerJava) = "The brick's Java is older and has no ${name(what)}."

    override fun insteadOf(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> {
            "Leave the \"<...>\" away. When you take something out, write its type before it: (String) " +
                "list.elementAt(0)."
        }

        NewerJava.FOR_EACH -> "Count instead: for (int i = 0; i < values.length; i++)."
        NewerJava.VARARGS -> "Use an array, such as int[]."
        NewerJava.ANNOTATION -> "Leave it away."
        NewerJava.ENUM -> "Use numbers with names: static final int RED = 0, GREEN = 1;"
        NewerJava.STATIC_IMPORT -> "Import the class, and write its name before the method."
        NewerJava.INTERFACE_METHOD_BODY -> "Write the method in a class."
        NewerJava.LAMBDA -> "Write a class for it, such as new Thread() { public void run() { ... } }."
        NewerJava.MULTI_CATCH -> "Write a \"catch\" for each."
        NewerJava.TRY_WITH_RESOURCES -> "Write the statement before the \"try\"."
        NewerJava.SWITCH_EXPRESSION -> "Use \"if\" and \"else\"."
        NewerJava.AUTOBOXING -> "Use \"int\", or \"new Integer(...)\" to put a number into a Vector."
        NewerJava.DIAMOND -> "Write the types in the brackets, too, such as new ArrayList<String>()."
        NewerJava.TEXT_IN_SWITCH -> "Use \"if\" and \"equals\": if (word.equals(\"go\"))."
        NewerJava.ASSERT -> "Use \"if\"."
        NewerJava.VAR -> "Write the type, such as \"int\"."
        NewerJava.TEXT_BLOCK -> "Write a text between two quotation marks, on one line."
        NewerJava.NUMBER_STYLE -> "Write the number with digits only."
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
        NewerJava.DIAMOND -> "empty \"<>\""
        NewerJava.TEXT_IN_SWITCH -> "\"switch\" with a text"
        NewerJava.ASSERT -> "\"assert\""
        NewerJava.VAR -> "\"var\""
        NewerJava.TEXT_BLOCK -> "texts between three quotation marks"
        NewerJava.NUMBER_STYLE -> "\"_\" in numbers, and no numbers that begin with \"0b\""
    }

    override fun absent(what: UnsupportedOnBrick) = when (what) {
        UnsupportedOnBrick.PRINTING -> {
            "The brick shows numbers with LCD.showNumber(7) and up to five letters with TextLCD.print(\"hello\")."
        }

        UnsupportedOnBrick.KEYBOARD -> "The brick has no keyboard. Ask its buttons, such as Button.VIEW.isPressed()."
        UnsupportedOnBrick.COLLECTIONS -> "Use an array, such as int[], or a Vector from java.util."

        UnsupportedOnBrick.VECTOR_METHODS -> {
            "A brick's Vector has addElement(), elementAt(), setElementAt(), removeElementAt() and size()."
        }

        UnsupportedOnBrick.HASHTABLE_METHODS -> {
            "A Hashtable on the brick has put() and get(), and get() gives null for what is not in it."
        }

        UnsupportedOnBrick.RUNNABLE -> "Write \"extends Thread\" instead, with a method \"public void run()\"."
        UnsupportedOnBrick.FORMATTING -> "The brick cannot format texts. Show a number with LCD.showNumber(7)."

        UnsupportedOnBrick.TEXT_METHODS -> {
            "A text on the brick has length(), charAt(), toCharArray() and equals(), and little more."
        }

        UnsupportedOnBrick.PARSING -> "The brick cannot read numbers from texts."
        UnsupportedOnBrick.WRAPPERS -> "Use boolean, char, int or float itself."

        UnsupportedOnBrick.WRITING_NUMBERS -> {
            "Integer.toString(number) makes a text of a whole number. LCD.showNumber(number) shows it without one."
        }

        UnsupportedOnBrick.SYSTEM_METHODS -> "System.currentTimeMillis() is the time, and memory is never taken back."
        UnsupportedOnBrick.ARRAY_COPYING -> "Copy one element after the other in a \"for\"."
        UnsupportedOnBrick.WAITING -> "Thread.sleep(1000) waits a second."
        UnsupportedOnBrick.FILES -> "The brick has no files."
        UnsupportedOnBrick.WINDOWS -> "The brick has no windows. It shows numbers and short texts with LCD and TextLCD."

        UnsupportedOnBrick.MOTOR_DIRECTIONS -> {
            "A motor has forward(), backward() and stop(), such as Motor.A.forward();"
        }

        UnsupportedOnBrick.MOTOR_TIME -> {
            "A motor of an RCX counts no degrees. Let it turn for a time: forward(), Thread.sleep(500), stop()"
        }

        UnsupportedOnBrick.MOTOR_POWER -> "A motor has setPower(), from 0 to 7."
        UnsupportedOnBrick.OTHER_BRICKS -> "That is for newer bricks. The classes of this one are in josx.platform.rcx."
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
