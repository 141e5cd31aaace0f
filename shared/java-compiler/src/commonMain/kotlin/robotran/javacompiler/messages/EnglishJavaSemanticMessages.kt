package robotran.javacompiler.messages

import robotran.language.quoted

internal object EnglishJavaSemanticMessages : JavaSemanticMessages {
    override fun doesNotFit(given: String, needed: String) =
        "This is of type ${quoted(given)}, and ${quoted(needed)} is needed here."

    override fun castNumber(type: String) =
        "Write \"($type)\" before it, with brackets around it, if a part of it may get lost."

    override fun notWhole(number: String, type: String) =
        "$number has a point, and ${quoted(type)} holds whole numbers only."

    override fun writeWhole(number: String) = "Write a whole number, such as $number."

    override fun writeWholeOrDeclare(number: String, declaration: String) =
        "Write a whole number, such as $number. For numbers with a point, declare the variable like this: $declaration"

    override fun tooLargeFor(number: String, type: String) = "$number does not fit into ${quoted(type)}."

    override fun declareAsInt() = "Declare the variable as \"int\"."

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

    override fun wrongArguments(method: String, needed: String, given: String) = when {
        given.isEmpty() -> "${quoted(method)} needs something in its brackets, as in: $method($needed)"
        needed.isEmpty() -> "${quoted(method)} has nothing in its brackets: $method()"
        else -> "${quoted(method)} takes ($needed), not ($given)."
    }

    override fun staticNeeded(name: String) =
        "${quoted(name)} belongs to an object, and in a \"static\" method there is none."

    override fun makeItStatic() = "Write \"static\" before it where it is declared."

    override fun objectNeeded(name: String, owner: String) =
        "${quoted(name)} needs an object of ${quoted(owner)}, not the class."

    override fun neverChanges(name: String) = "${quoted(name)} is \"final\", so it can be set only once."

    override fun numberTooLarge(number: String) =
        "$number is too large. An \"int\" goes from -2147483648 to 2147483647."

    override fun noLeadingZero(number: String) = "A whole number begins with no 0 in Java. Write $number."

    override fun countsMilliseconds() = "It counts whole milliseconds: half a second is 500."

    override fun sleepInstead() = "To let time pass, write Thread.sleep(500), which is half a second."

    override fun callOnObject(name: String) = "Write before it which object it is for, as in: lock.$name()"

    override fun callOnNew(className: String, name: String) =
        "Make an object first, and call it there: new $className().$name()"

    override fun announcesMore(exception: String, method: String) =
        "This method takes the place of ${quoted(method)}, which announces no $exception. So it must not, either."

    override fun catchInside(exception: String) =
        "Take this \"throws\" away, and put what can cause it into try { ... } catch ($exception e) { }."

    override fun noEffect() = "This changes nothing."

    override fun emptyStatement() = "This \";\" is all that is done here. Take it away if a block comes next."

    override fun wrongOperator(operator: String, types: String) =
        "${quoted(operator)} does not work with ${quoted(types)}."
}
