package robotran.javacompiler.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted

internal object GermanJavaSyntaxMessages : JavaSyntaxMessages {
    override fun missingSemicolon() = "Ans Ende dieser Anweisung gehört ein \";\"."

    override fun missingBracket(bracket: String) =
        "Hier steht ein ${quoted(openingOf(bracket))} ohne sein ${quoted(bracket)}."

    override fun extraBracket(bracket: String) = "Dieses ${quoted(bracket)} ist eins zu viel, oder davor fehlt etwas."

    override fun expectedInstead(word: String, expected: String) =
        "Java erwartet hier ${quoted(expected)}, nicht ${quoted(word)}."

    override fun expectedAfter(word: String, expected: String) =
        "Java erwartet ${quoted(expected)} nach ${quoted(word)}."

    override fun notUnderstood(word: String) = "Java kann hier mit ${quoted(word)} nichts anfangen."

    override fun somethingMissing(word: String) = "Nach ${quoted(word)} fehlt etwas."

    override fun compilerSays(english: String) =
        "Hier ist etwas, das Java nicht erlaubt. Der Compiler sagt es auf Englisch: $english"

    override fun unclosedString() = "Diesem Text fehlt das Anführungszeichen am Ende."

    override fun closeString() =
        "Setz ein Anführungszeichen hinter seinen letzten Buchstaben. Ein Text kann nicht in der nächsten Zeile " +
            "weitergehen."

    override fun pasted(character: PastedCharacter) = character.adviceIn(Language.GERMAN)

    override fun unclosedComment() = "Dieser Kommentar hört nicht auf. Schreib \"*/\" hinter sein letztes Wort."

    override fun wrongCharacter() =
        "Zwischen einfachen Anführungszeichen steht genau ein Zeichen. Ein Text hat doppelte."

    override fun foreignWord(word: String, javaWord: String) = "Java sagt ${quoted(javaWord)} statt ${quoted(word)}."

    override fun noSuchWord(word: String) = "Java hat kein ${quoted(word)}. Lass es weg."

    override fun conditionInBrackets(word: String) =
        "Was nach ${quoted(word)} kommt, steht in Klammern, zum Beispiel: ${exampleOf(word)}"

    override fun semicolonsInFor() = "Zwischen den drei Teilen eines \"for\" steht \";\": for (int i = 0; i < 4; i++)"

    override fun elseWithoutIf() =
        "Zu diesem \"else\" gibt es kein \"if\". Such nach einem \";\" gleich hinter dem \"if\" oder nach einem " +
            "fehlenden \"{\" oder \"}\"."

    override fun outsideMethod() = "Diese Anweisung steht in einer Klasse, aber in keiner ihrer Methoden."

    override fun moveIntoMethod() = "Schieb sie zwischen die geschweiften Klammern einer Methode, zum Beispiel main."

    override fun outsideClass() = "Das steht in keiner Klasse, und in Java steht alles in einer."

    override fun moveIntoClass(className: String) =
        "Schieb es zwischen die geschweiften Klammern der Klasse ${quoted(className)}."

    override fun methodInMethod(name: String) =
        "Die Methode ${quoted(name)} steht in einer anderen Methode, und das gibt es in Java nicht."

    override fun moveOutOfMethod() =
        "Schieb sie heraus, hinter das \"}\" dieser Methode, mit ihren geschweiften Klammern und allem darin."

    override fun nameIsOneWord(name: String) = "Der Name einer Klasse ist ein einziges Wort: $name"

    override fun decimalPoint(number: String) = "Eine Kommazahl hat in Java einen Punkt, kein Komma: $number"

    override fun putIntoClass(className: String) =
        "Schreib \"public class $className {\" darüber und \"}\" ganz ans Ende."

    override fun beginWithClass(className: String) =
        "Beginn mit: public class $className { public static void main(String[] args) { und hör auf mit: } }"

    override fun callWithBrackets(name: String) =
        "Um die Methode ${quoted(name)} aufzurufen, setz Klammern dahinter: $name()"

    override fun noStatement() = "Hier wird etwas ausgerechnet, aber nichts damit gemacht."

    override fun setWithOneSign() =
        "Zwei Zeichen vergleichen. Um einer Variable einen Wert zu geben, schreib nur ein \"=\"."

    override fun reservedWord(word: String) =
        "${quoted(word)} ist ein eigenes Wort von Java, also kann nichts so heißen. Nimm einen anderen Namen."

    override fun nameBeginsWithLetter() = "Ein Name beginnt mit einem Buchstaben, nicht mit einer Ziffer."

    override fun typeOfParameter() =
        "In den Klammern einer Methode steht vor jedem Namen sein Typ, zum Beispiel: (int speed)"

    override fun lengthOfArray() = "Ein Array bekommt seine Länge dort, wo es gemacht wird: int[] values = new int[3];"

    override fun arrayOfValues() = "Schreib vor die geschweiften Klammern, was gemacht wird: new int[] {1, 2, 3}"

    override fun tryAlone() = "Dieses \"try\" hat kein \"catch\"."

    override fun addCatch() = "Schreib hinter sein \"}\": catch (InterruptedException e) { }"

    override fun compilerFailed() =
        "Der Compiler ist mit diesem Programm nicht fertig geworden. Nimm deine letzte Änderung weg und versuch es " +
            "noch einmal."
}
