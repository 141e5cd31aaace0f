package robotran.java

/** What is told in English about names that nothing declares. */
internal object EnglishJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "There is no class ${quoted(name)}."

    override fun unknownVariable(name: String) = "There is no variable ${quoted(name)}."

    override fun unknownMethod(name: String, owner: String) = "${quoted(owner)} has no method ${quoted(name)}."

    override fun unknownField(name: String, owner: String?) =
        if (owner == null) "There is no ${quoted(name)} here." else "${quoted(owner)} has no ${quoted(name)}."

    override fun unknownImport(name: String) = "The brick has no ${quoted(name)}."

    override fun didYouMean(suggestion: String) = "Did you mean ${quoted(suggestion)}?"

    override fun importIt(line: String) = "Write ${quoted(line)} at the top."

    override fun declareIt(name: String) = "Declare it first, such as with \"int $name = 0;\"."
}
