package robotran.java

/** What is told in English about programs that can be read but make no sense. */
internal object EnglishJavaMeaningMessages : JavaMeaningMessages {
    override fun doesNotFit(given: String, needed: String) = "This is of type ${quoted(given)}, and ${quoted(needed)} is needed here."

    override fun castIt(type: String) = "Write \"($type)\" before it, with brackets around it, if a part of it may get lost."

    override fun writeFloat(number: String) = "Write \"${number}f\"."

    override fun compareWithTwoSigns() = "To compare, write \"==\". A single \"=\" sets a variable."

    override fun makeText() = "Write \"\" + before it to make it a text."

    override fun notInitialized(name: String) = "${quoted(name)} may have no value yet. Give it one where it is declared."

    override fun declaredTwice(name: String) =
        "${quoted(name)} is declared already. Take another name, or leave its type away to set it."

    override fun returnsNothing() = "This method is \"void\", so it gives nothing back. Write \"return;\" or change its type."

    override fun mustReturn() = "This method has to give a value back on every way through it. Write \"return\" and the value."

    override fun neverReached() = "The program never gets here, because of what stands before it."

    override fun unhandledException(name: String) = "${quoted(name)} can happen here, and nothing takes care of it."

    override fun passItOn(name: String) =
        "Write \"throws $name\" behind the brackets of the method, as in \"main(String[] args) throws $name\"."

    override fun wrongArguments(method: String, needed: String, given: String) =
        "${quoted(method)} takes ${inBrackets(needed)}, not ${inBrackets(given)}."

    override fun staticNeeded(name: String) = "${quoted(name)} belongs to an object, and in a \"static\" method there is none."

    override fun makeItStatic() = "Write \"static\" before it where it is declared."

    override fun wrongFileName(className: String) =
        "A public class is in a file of its own name. Call the file ${quoted("$className.java")}."

    override fun numberTooLarge(number: String) = "$number is too large. An \"int\" goes from -2147483648 to 2147483647."

    override fun noEffect() = "This changes nothing."

    override fun emptyStatement() = "This \";\" is all that is done here. Take it away if a block comes next."

    override fun wrongOperator(operator: String) = "${quoted(operator)} does not work with these types."

    private fun inBrackets(types: String) = if (types.isEmpty()) "no values" else "($types)"
}
