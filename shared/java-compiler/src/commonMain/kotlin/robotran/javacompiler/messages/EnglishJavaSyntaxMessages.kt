package robotran.javacompiler.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted

internal object EnglishJavaSyntaxMessages : JavaSyntaxMessages {
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

    override fun pasted(character: PastedCharacter) = character.adviceIn(Language.ENGLISH)

    override fun unclosedComment() = "This comment does not end. Write \"*/\" behind its last word."

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

    override fun moveIntoClass(className: String) = "Move it between the braces of the class ${quoted(className)}."

    override fun methodInMethod(name: String) =
        "The method ${quoted(name)} is inside another method, which Java does not have."

    override fun moveOutOfMethod() =
        "Move it out, behind the \"}\" of that method, with its braces and what is in them."

    override fun nameIsOneWord(name: String) = "The name of a class is one word: $name"

    override fun decimalPoint(number: String) = "A decimal number has a point, not a comma: $number"

    override fun putIntoClass(className: String) =
        "Write \"public class $className {\" above it, and \"}\" at the very end."

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

    override fun compilerFailed() =
        "The compiler gave up on this program. Take away what you changed last, and try again."
}
