package robotran.javacompiler.messages

/** What is told about programs that can be read but make no sense. */
interface JavaMeaningMessages {
    fun doesNotFit(given: String, needed: String): String

    /** A number that may lose a part of itself. */
    fun castNumber(type: String): String

    /** An `Object`, such as a `Vector` gives back, that is something more. */
    fun castObject(type: String): String

    fun writeFloat(number: String): String

    fun compareWithTwoSigns(): String

    fun compareWithZero(): String

    fun makeText(): String

    fun givesNothing(): String

    fun notInitialized(name: String): String

    fun declaredTwice(name: String): String

    fun returnsNothing(): String

    fun mustReturn(): String

    fun returnValue(): String

    fun neverReached(): String

    fun unhandledException(name: String): String

    fun handleIt(name: String): String

    fun neverThrown(name: String): String

    fun takeCatchAway(): String

    fun wrongArguments(method: String, needed: String, given: String): String

    fun staticNeeded(name: String): String

    fun makeItStatic(): String

    /** A method [name] of objects, called on the class [owner]. */
    fun objectNeeded(name: String, owner: String): String

    fun neverChanges(name: String): String

    fun numberTooLarge(number: String): String

    fun noEffect(): String

    fun emptyStatement(): String

    fun wrongOperator(operator: String, types: String): String
}

/** What is told about classes and methods as a whole. */
interface JavaClassMessages {
    fun wrongFileName(className: String): String

    /** [keyword] is `void` or another type. */
    fun missingReturnType(): String

    fun writeVoid(): String

    /** Objects of the class [name] cannot be made with `new`. */
    fun cannotBeMade(name: String): String

    fun extendThread(): String

    fun extendIt(name: String): String

    /** [owner] asks [className] to have a method [method]. */
    fun mustHaveMethod(className: String, method: String, owner: String): String

    fun writePublicMethod(method: String): String

    fun mustBePublic(method: String): String

    fun noMain(): String

    /** There is a method that is called like it, but it is not declared as it must be. */
    fun wrongMain(): String

    fun writeMain(): String
}
