package robotran.javacompiler.messages

import robotran.language.quoted

internal object SpanishJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "No existe la clase ${quoted(name)}."

    override fun severalClasses(name: String) = "Varios de los paquetes que importas tienen una clase ${quoted(name)}."

    override fun unknownVariable(name: String) = "No existe la variable ${quoted(name)}."

    override fun classIsNoValue(name: String) =
        "${quoted(name)} es una clase, no un valor. Detrás van un punto y un nombre."

    override fun unknownMethod(name: String, owner: String) = "${quoted(owner)} no tiene ningún método ${quoted(name)}."

    override fun unknownMethodHere(name: String, owner: String) =
        "${quoted(owner)} no tiene ningún método ${quoted(name)}, y delante no hay ninguna clase."

    override fun unknownField(name: String, owner: String?) =
        if (owner == null) "Aquí no existe ${quoted(name)}." else "${quoted(owner)} no tiene ${quoted(name)}."

    override fun unknownImport(name: String) = "El ladrillo no tiene ${quoted(name)}."

    override fun didYouMean(suggestion: String) = "¿Querías decir ${quoted(suggestion)}?"

    override fun wrongCase(suggestion: String) =
        "Escribe ${quoted(suggestion)}: Java distingue las minúsculas de las mayúsculas."

    override fun importIt(line: String) = "Escribe ${quoted(line)} arriba del todo."

    override fun declareIt(name: String) = "Declárala antes, por ejemplo con \"int $name = 0;\"."

    override fun writeMethod(name: String, parameters: String) = "Escribe el método: static void $name($parameters) { }"

    override fun valueInBrackets(name: String, call: String) =
        "${quoted(name)} es un método. Su valor va entre paréntesis: $call"

    override fun isPrivate(name: String, owner: String) =
        "${quoted(name)} es privado: solo puede usarlo la propia ${quoted(owner)}."

    override fun usePublic() = "Quita \"private\" donde se declara, o usa un método que su clase tenga para eso."

    override fun lengthOfArrayValue() = "La longitud de un array no lleva paréntesis: values.length"

    override fun lengthOfTextOrArray() =
        "La longitud de un texto lleva paréntesis, word.length(), y la de un array no los lleva, values.length."

    override fun noArray(type: String) = "Solo un array lleva \"[...]\" detrás, y esto es un ${quoted(type)}."

    override fun charAt() = "Una letra de un texto es word.charAt(0), donde la primera tiene el número 0."

    override fun noMembers(type: String) = "Esto es de tipo ${quoted(type)}, un valor suelto, y no tiene métodos."
}
