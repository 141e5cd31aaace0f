package robotran.tinyvm.messages

import robotran.tinyvm.config.Quirk

object EnglishTinyVmMessages :
    TinyVmMessages,
    ClassFileMessages by EnglishClassFileMessages,
    LinkMessages by EnglishLinkMessages,
    RunMessages by EnglishVmRunMessages

private object EnglishClassFileMessages : ClassFileMessages {
    override fun notAClassFile() = "This is not a class file: compile the program again."

    override fun classFileTooLong(limit: Int) = "This class file is longer than $limit bytes. A brick holds far less."

    override fun classFileTooNew() =
        "This class was compiled for a newer Java than a brick understands. Compile it with --release 8, or open its " +
            "source here."

    override fun classFileDamaged() = "This class file is damaged: compile the program again."
}

private object EnglishLinkMessages : LinkMessages {
    override fun noMainMethod() =
        "There is nothing to start: write a method \"public static void main(String[] args)\" in one class."

    override fun classMissing(name: String) = "There is no class $name on the brick."

    override fun fieldMissing(className: String, name: String) = when (className to name) {
        "java.lang.System" to "out" -> {
            "The brick has no System.out. Show texts with TextLCD.print, and numbers with LCD.showNumber."
        }

        else -> "On the brick, $className has no \"$name\"."
    }

    override fun methodMissing(className: String, name: String) = "On the brick, $className has no method \"$name\"."

    override fun duplicateClass(name: String) = "There are two classes called $name. Give one another name."

    override fun cyclicInheritance(name: String) = "The class $name cannot extend itself."

    override fun tooMany(counted: Counted, limit: Int) = "A brick takes at most $limit ${nameOf(counted)}."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "This program takes about $bytes bytes of the brick's memory, but it has room for $limit. Use fewer classes " +
            "of leJOS, or write less code."

    override fun nativeMethod(name: String) =
        "The brick has no built-in method \"$name\". Write it in Java, without \"native\"."

    override fun unsupportedFeature(feature: UnsupportedFeature) = when (feature) {
        UnsupportedFeature.SWITCH -> "The brick does not know \"switch\". Use \"if\" and \"else if\" instead."

        UnsupportedFeature.LONG_ARITHMETIC -> {
            "The brick cannot calculate with long numbers or compare them. Turn them into int first: " +
                "(int) time."
        }

        UnsupportedFeature.DECIMAL_REMAINDER -> "The brick knows % only for whole numbers."
        UnsupportedFeature.FAR_JUMP -> "This method is too long for the brick. Move parts of it into other methods."
        UnsupportedFeature.MANY_LOCALS -> "A method can have at most 255 variables on the brick."

        UnsupportedFeature.MANY_CONSTANTS -> {
            "This class has too many different texts and large numbers for the brick. Move some into " +
                "another class."
        }

        UnsupportedFeature.INVOKE_DYNAMIC -> {
            "The brick does not know lambdas or newer ways to join texts. Compile for an older Java, or " +
                "write a class."
        }

        UnsupportedFeature.ARRAY_TEST -> {
            "The brick cannot test or cast arrays. Keep the array in a variable of its own type."
        }

        UnsupportedFeature.CLASS_LITERAL -> "On the brick, classes are no objects: there is no \".class\"."
        UnsupportedFeature.INTERFACE_CODE -> "On the brick, an interface only names methods, it has no code in it."

        UnsupportedFeature.NESTED_FINALLY -> {
            "Too many \"finally\" blocks are inside each other here. Move some into other methods."
        }
    }

    override fun codeInvalid() = "This class file is damaged, its code makes no sense: compile the program again."

    private fun nameOf(counted: Counted) = when (counted) {
        Counted.CLASSES -> "classes in a program, those of leJOS included"
        Counted.ARRAY_TYPES -> "kinds of arrays in a program"
        Counted.FIELDS -> "fields in a class"
        Counted.METHODS -> "methods in a class"
        Counted.LOCALS -> "variables in a method"
        Counted.OPERANDS -> "values inside one calculation"
        Counted.PARAMETERS -> "parameters of a method, with \"this\" counted and long and double counted twice"
        Counted.HANDLERS -> "\"catch\" and \"finally\" in a method"
        Counted.CODE_BYTES -> "bytes of code in a method"
        Counted.TEXT_CHARACTERS -> "characters in a text"
        Counted.ANCESTORS -> "classes and interfaces above a class"
    }
}

private object EnglishVmRunMessages : RunMessages {
    override val nxt = EnglishNxtRunMessages

    override fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        val digit = exceptionNumber % 10
        val number = if (digit == exceptionNumber) "$digit" else "$digit, the last digit of $exceptionNumber"
        return "Nobody caught the $said. A brick buzzes and shows $methodNumber and $number."
    }

    override fun quirkEffect(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "A brick divides only by numbers from -32768 to 32767. It drops the rest of a larger divisor."
        }

        Quirk.INDEX_OF_16_BITS -> "A brick looks only at 16 bits of an index, so a large one meets another element."
        Quirk.SIGNED_CHARACTER -> "On a brick, a char above 32767 becomes negative."

        Quirk.UNCHECKED_INTERFACE -> {
            "On a brick, every object passes for any interface: this test or cast was not really made."
        }

        Quirk.LONG_ARRAY -> "On a brick, an array has at most 511 elements."

        Quirk.HEAP_FULL -> {
            "The brick's memory is full. It never gives memory back, so make objects, arrays and texts once and use " +
                "them again."
        }

        Quirk.NOT_A_NUMBER -> "This decimal number is no number, and a brick takes it as equal to all others."
        Quirk.JOIN_DOES_NOTHING -> "On a brick, join does not wait. Ask isAlive in a loop instead."

        Quirk.UNLOCKED_METHOD -> {
            "A brick locks nothing in a synchronized method that is private or static, or that is called with " +
                "super: wait and notify fail in it, and other threads can come in. Make it neither private nor " +
                "static."
        }

        Quirk.DEEP_ARRAY -> {
            "A brick cannot create an array of three or more dimensions at once: it throws an OutOfMemoryError. " +
                "Create the inner arrays in a loop."
        }

        Quirk.DEEP_CALLS -> {
            "A brick has room for about 210 calls inside each other, and for fewer if they have many variables or " +
                "its memory is full."
        }

        Quirk.LATE_INITIALIZER -> {
            "A brick prepares the static fields of a class when that class itself is first used, so here those of " +
                "the superclass are not ready yet."
        }

        Quirk.EARLY_HANDLER -> {
            "A brick also lets a try take care of what goes wrong in the statement directly before it. Put another " +
                "statement in between, such as int next = 0;"
        }

        Quirk.NEGATIVE_TIME -> "A brick does not pause for a time below 0, and throws no exception."

        Quirk.NEGATIVE_LONG -> {
            "A brick takes a negative long for a large positive number when it becomes a decimal number. Turn it " +
                "into an int first: (int) time."
        }

        Quirk.UNCHECKED_ELEMENT -> {
            "A brick does not check what you store in an array. This object is of another class, so nothing good " +
                "comes of it: here null is stored instead."
        }

        Quirk.LOST_EXCEPTION -> {
            "After a failed cast or a failed new array, a brick does not give the exception to catch: the variable " +
                "is null or holds what it held before. Do not use it there."
        }
    }

    override fun programMemoryUse(programBytes: Int, allBytes: Int) =
        "Of its $allBytes bytes, the program itself takes about $programBytes."

    override fun quirkWarning(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> "A real brick would drop all but 16 bits of this divisor and get another result."

        Quirk.INDEX_OF_16_BITS -> {
            "A real brick would drop all but 16 bits of this index and might meet another element."
        }

        Quirk.SIGNED_CHARACTER -> "On a real brick, this char would become negative."
        Quirk.UNCHECKED_INTERFACE -> "A real brick would not notice that the object does not implement this interface."
        Quirk.LONG_ARRAY -> "A real brick has no arrays of more than 511 elements: it would throw an OutOfMemoryError."
        Quirk.HEAP_FULL -> "A real brick's memory would be full by now: it never gives memory back."
        Quirk.NOT_A_NUMBER -> "A real brick would take this as equal to all other numbers."
        Quirk.JOIN_DOES_NOTHING -> "On a real brick, join does not wait, so here it does not either."

        Quirk.UNLOCKED_METHOD -> {
            "A real brick would lock nothing here: it ignores \"synchronized\" of a method that is private or " +
                "static, or that is called with super."
        }

        Quirk.DEEP_ARRAY -> {
            "A real brick cannot create an array of three or more dimensions at once: it would throw an " +
                "OutOfMemoryError."
        }

        Quirk.DEEP_CALLS -> {
            "A real brick has room for about 210 calls inside each other, fewer with many variables: it would throw " +
                "a StackOverflowError."
        }

        Quirk.LATE_INITIALIZER -> {
            "A real brick would not have prepared the static fields of the superclass here: it does so when that " +
                "class itself is first used."
        }

        Quirk.EARLY_HANDLER -> {
            "On a real brick, the try after this statement would take care of this, too. Put another statement in " +
                "between, such as int next = 0;"
        }

        Quirk.NEGATIVE_TIME -> "A real brick would not pause here, and would throw no exception."
        Quirk.NEGATIVE_LONG -> "A real brick would take this negative long for a large positive number."

        Quirk.UNCHECKED_ELEMENT -> {
            "A real brick would not notice that this object is of another class than the elements of the array."
        }

        Quirk.LOST_EXCEPTION -> {
            "A real brick would not give this exception to catch: its variable would be null or hold what it held " +
                "before."
        }
    }
}
