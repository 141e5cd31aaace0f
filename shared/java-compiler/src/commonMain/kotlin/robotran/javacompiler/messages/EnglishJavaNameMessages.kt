package robotran.javacompiler.messages

import robotran.language.quoted

internal object EnglishJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "There is no class ${quoted(name)}."

    override fun severalClasses(name: String) = "Several of the packages that you import have a class ${quoted(name)}."

    override fun unknownVariable(name: String) = "There is no variable ${quoted(name)}."

    override fun classIsNoValue(name: String) =
        "${quoted(name)} is a class, not a value. A point and a name come behind it."

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

    override fun writeMethod(name: String, parameters: String) = "Write the method: static void $name($parameters) { }"

    override fun valueInBrackets(name: String, call: String) =
        "${quoted(name)} is a method. Its value stands in brackets: $call"

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
