package robotran.javacompiler.messages

import robotran.language.quoted

internal object EnglishJavaClassMessages : JavaClassMessages {
    override fun wrongFileName(className: String) =
        "A public class is in a file of its own name. Call the file ${quoted("$className.java")}, or the class like " +
            "the file."

    override fun missingReturnType() = "This method says no type of what it gives back."

    override fun writeVoid() = "Write \"void\" before its name, if it gives nothing back."

    override fun cannotInstantiate(name: String) =
        "Java cannot make a ${quoted(name)} with \"new\", because a part of it is still to be written."

    override fun wrongConstructor(name: String, given: String) = if (given.isEmpty()) {
        "A ${quoted(name)} is not made of nothing."
    } else {
        "A ${quoted(name)} is not made of ($given)."
    }

    override fun makeItLike(ways: String) = "Make it like this: $ways"

    override fun sayWherePluggedIn(example: String) = "Say where it is plugged in: $example"

    override fun madeAlready(name: String) = "A program makes no ${quoted(name)} with \"new\"."

    override fun useOneOf(constants: String) = "Use one that is there: $constants"

    override fun callOnClass(name: String) = "Call its methods with the name of the class: $name."

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
