package robotran.javacompiler.messages

import robotran.language.quoted

internal object GermanJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "Es gibt keine Klasse ${quoted(name)}."

    override fun severalClasses(name: String) = "Mehrere der importierten Pakete haben eine Klasse ${quoted(name)}."

    override fun unknownVariable(name: String) = "Es gibt keine Variable ${quoted(name)}."

    override fun classIsNoValue(name: String) =
        "${quoted(name)} ist eine Klasse und kein Wert. Dahinter kommen ein Punkt und ein Name."

    override fun unknownMethod(name: String, owner: String) = "${quoted(owner)} hat keine Methode ${quoted(name)}."

    override fun unknownMethodHere(name: String, owner: String) =
        "${quoted(owner)} hat keine Methode ${quoted(name)}, und es steht keine Klasse davor."

    override fun unknownField(name: String, owner: String?) =
        if (owner == null) "Hier gibt es kein ${quoted(name)}." else "${quoted(owner)} hat kein ${quoted(name)}."

    override fun unknownImport(name: String) = "Der Stein hat kein ${quoted(name)}."

    override fun didYouMean(suggestion: String) = "Meinst du ${quoted(suggestion)}?"

    override fun wrongCase(suggestion: String) =
        "Schreib ${quoted(suggestion)}: Java unterscheidet kleine und große Buchstaben."

    override fun importIt(line: String) = "Schreib ${quoted(line)} ganz nach oben."

    override fun declareIt(name: String) = "Leg sie vorher an, zum Beispiel mit \"int $name = 0;\"."

    override fun writeMethod(name: String, parameters: String) =
        "Schreib die Methode: static void $name($parameters) { }"

    override fun valueInBrackets(name: String, call: String) =
        "${quoted(name)} ist eine Methode. Ihr Wert steht in Klammern: $call"

    override fun isPrivate(name: String, owner: String) =
        "${quoted(name)} ist privat: Nur ${quoted(owner)} selbst darf es benutzen."

    override fun usePublic() =
        "Nimm dort, wo es angelegt wird, \"private\" weg, oder nimm eine Methode, die seine Klasse dafür hat."

    override fun lengthOfArrayValue() = "Die Länge eines Arrays hat keine Klammern: values.length"

    override fun lengthOfTextOrArray() =
        "Die Länge eines Textes hat Klammern, word.length(), und die eines Arrays hat keine, values.length."

    override fun noArray(type: String) =
        "Nur ein Array hat \"[...]\" hinter sich, und das hier ist ein ${quoted(type)}."

    override fun charAt() = "Ein Buchstabe eines Textes ist word.charAt(0), wobei der erste die Nummer 0 hat."

    override fun noMembers(type: String) =
        "Das ist vom Typ ${quoted(type)}, ein einzelner Wert, und hat keine Methoden."
}
