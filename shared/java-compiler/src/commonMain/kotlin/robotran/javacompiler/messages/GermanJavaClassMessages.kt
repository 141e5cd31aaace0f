package robotran.javacompiler.messages

import robotran.language.quoted

internal object GermanJavaClassMessages : JavaClassMessages {
    override fun wrongFileName(className: String) =
        "Eine öffentliche Klasse steht in einer Datei mit ihrem Namen. Nenn die Datei ${quoted("$className.java")}, " +
            "oder die Klasse wie die Datei."

    override fun missingReturnType() = "Diese Methode sagt nicht, von welchem Typ das ist, was sie zurückgibt."

    override fun writeVoid() = "Schreib \"void\" vor ihren Namen, wenn sie nichts zurückgibt."

    override fun cannotInstantiate(name: String) =
        "Java kann kein ${quoted(name)} mit \"new\" machen, weil ein Teil davon noch nicht geschrieben ist."

    override fun wrongConstructor(name: String, given: String) = if (given.isEmpty()) {
        "Ein ${quoted(name)} wird nicht aus nichts gemacht."
    } else {
        "Ein ${quoted(name)} wird nicht aus ($given) gemacht."
    }

    override fun makeItLike(ways: String) = "Mach es so: $ways"

    override fun sayWherePluggedIn(example: String) = "Sag, wo er angeschlossen ist: $example"

    override fun madeAlready(name: String) = "Ein Programm macht kein ${quoted(name)} mit \"new\"."

    override fun useOneOf(constants: String) = "Nimm eins, das es schon gibt: $constants"

    override fun callOnClass(name: String) = "Ruf seine Methoden mit dem Namen der Klasse auf: $name."

    override fun extendThread() =
        "Schreib eine Klasse mit \"extends Thread\" und einer Methode \"public void run()\", und mach davon ein " +
            "Objekt. " +
            "Auf dem Stein nimmt Thread kein Runnable."

    override fun extendIt(name: String) =
        "Schreib eine Klasse, die ein $name ist und alle seine Methoden hat, und mach davon ein Objekt."

    override fun mustHaveMethod(className: String, method: String, owner: String) =
        "${quoted(className)} ist ein ${quoted(owner)}, also muss es die Methode ${quoted(method)} haben."

    override fun writePublicMethod(method: String) =
        "Schreib sie mit \"public\" davor, zum Beispiel: public void $method { }"

    override fun mustBePublic(method: String) = "Vor ${quoted(method)} muss \"public\" stehen."

    override fun noMain() = "Der Stein weiß nicht, wo er anfangen soll: Keine Klasse hat eine Methode \"main\"."

    override fun wrongMain() =
        "Der Stein weiß nicht, wo er anfangen soll, denn diese Methode ist nicht so angelegt, wie \"main\" es sein " +
            "muss."

    override fun writeMain() = "Schreib sie so: public static void main(String[] args) { }"
}
