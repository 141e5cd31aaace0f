package robotran.javacompiler.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted

internal object SpanishJavaSyntaxMessages : JavaSyntaxMessages {
    override fun missingSemicolon() = "Pon un \";\" al final de esta instrucción."

    override fun missingBracket(bracket: String) = "Hay un ${quoted(openingOf(bracket))} sin su ${quoted(bracket)}."

    override fun extraBracket(bracket: String) = "Este ${quoted(bracket)} sobra, o falta algo antes."

    override fun expectedInstead(word: String, expected: String) =
        "Java espera aquí ${quoted(expected)}, no ${quoted(word)}."

    override fun expectedAfter(word: String, expected: String) =
        "Java espera ${quoted(expected)} después de ${quoted(word)}."

    override fun notUnderstood(word: String) = "Java no entiende qué hace aquí ${quoted(word)}."

    override fun somethingMissing(word: String) = "Falta algo después de ${quoted(word)}."

    override fun compilerSays(english: String) =
        "Aquí hay algo que Java no admite. El compilador lo dice en inglés: $english"

    override fun unclosedString() = "A este texto le faltan las comillas del final."

    override fun closeString() =
        "Pon unas comillas detrás de su última letra. Un texto no puede seguir en la línea siguiente."

    override fun pasted(character: PastedCharacter) = character.adviceIn(Language.SPANISH)

    override fun unclosedComment() = "Este comentario no termina. Escribe \"*/\" detrás de su última palabra."

    override fun wrongCharacter() =
        "Entre comillas simples va exactamente una letra o un signo. Un texto las lleva dobles."

    override fun foreignWord(word: String, javaWord: String) =
        "En Java se dice ${quoted(javaWord)} en lugar de ${quoted(word)}."

    override fun noSuchWord(word: String) = "Java no tiene ${quoted(word)}. Quítalo."

    override fun conditionInBrackets(word: String) =
        "Lo que va después de ${quoted(word)} se escribe entre paréntesis, así: ${exampleOf(word)}"

    override fun semicolonsInFor() = "Las tres partes de un \"for\" se separan con \";\": for (int i = 0; i < 4; i++)"

    override fun elseWithoutIf() =
        "Para este \"else\" no hay ningún \"if\". Mira si hay un \";\" justo después del \"if\", o si falta un \"{\" " +
            "o un \"}\"."

    override fun outsideMethod() = "Esta instrucción está en una clase, pero en ninguno de sus métodos."

    override fun moveIntoMethod() = "Ponla entre las llaves de un método, como main."

    override fun outsideClass() = "Esto no está en ninguna clase, y en Java todo está en una."

    override fun moveIntoClass(className: String) = "Ponlo entre las llaves de la clase ${quoted(className)}."

    override fun methodInMethod(name: String) =
        "El método ${quoted(name)} está dentro de otro método, y eso no existe en Java."

    override fun moveOutOfMethod() = "Sácalo, detrás del \"}\" de ese método, con sus llaves y lo que hay en ellas."

    override fun nameIsOneWord(name: String) = "El nombre de una clase es una sola palabra: $name"

    override fun decimalPoint(number: String) = "Un número decimal lleva en Java un punto, no una coma: $number"

    override fun putIntoClass(className: String) =
        "Escribe \"public class $className {\" encima, y \"}\" al final del todo."

    override fun beginWithClass(className: String) =
        "Empieza con: public class $className { public static void main(String[] args) { y termina con: } }"

    override fun callWithBrackets(name: String) =
        "Para llamar al método ${quoted(name)}, pon paréntesis detrás: $name()"

    override fun noStatement() = "Esto calcula algo, pero luego no se hace nada con ello."

    override fun setWithOneSign() = "Dos signos comparan. Para dar valor a una variable, escribe un solo \"=\"."

    override fun reservedWord(word: String) =
        "${quoted(word)} es una palabra propia de Java, así que nada puede llamarse así. Elige otro nombre."

    override fun nameBeginsWithLetter() = "Un nombre empieza por una letra, no por una cifra."

    override fun typeOfParameter() =
        "Entre los paréntesis de un método, cada nombre lleva su tipo delante, así: (int speed)"

    override fun lengthOfArray() = "Un array recibe su longitud donde se crea: int[] values = new int[3];"

    override fun arrayOfValues() = "Escribe delante de las llaves qué se crea: new int[] {1, 2, 3}"

    override fun tryAlone() = "Este \"try\" no tiene \"catch\"."

    override fun addCatch() = "Escribe después de su \"}\": catch (InterruptedException e) { }"

    override fun compilerFailed() =
        "El compilador no ha podido con este programa. Quita lo último que has cambiado y prueba otra vez."
}
