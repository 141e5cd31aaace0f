package robotran.javacompiler.messages

import robotran.language.quoted

internal object SpanishJavaClassMessages : JavaClassMessages {
    override fun wrongFileName(className: String) =
        "Una clase pública está en un archivo con su mismo nombre. Llama al archivo ${quoted("$className.java")}, o " +
            "a la clase como al archivo."

    override fun missingReturnType() = "Este método no dice de qué tipo es lo que devuelve."

    override fun writeVoid() = "Escribe \"void\" delante de su nombre, si no devuelve nada."

    override fun cannotInstantiate(name: String) =
        "Java no puede crear un ${quoted(name)} con \"new\", porque le falta una parte por escribir."

    override fun wrongConstructor(name: String, given: String) = if (given.isEmpty()) {
        "Un ${quoted(name)} no se crea sin nada."
    } else {
        "Un ${quoted(name)} no se crea con ($given)."
    }

    override fun makeItLike(ways: String) = "Créalo así: $ways"

    override fun sayWherePluggedIn(example: String) = "Di dónde está conectado: $example"

    override fun madeAlready(name: String) = "Un programa no crea ningún ${quoted(name)} con \"new\"."

    override fun useOneOf(constants: String) = "Usa uno que ya existe: $constants"

    override fun callOnClass(name: String) = "Llama a sus métodos con el nombre de la clase: $name."

    override fun extendThread() =
        "Escribe una clase que \"extends Thread\" y tenga un método \"public void run()\", y crea un objeto de ella. " +
            "En un ladrillo, Thread no recibe ningún Runnable."

    override fun extendIt(name: String) =
        "Escribe una clase que sea un $name y tenga todos sus métodos, y crea un objeto de ella."

    override fun mustHaveMethod(className: String, method: String, owner: String) =
        "${quoted(className)} es un ${quoted(owner)}, así que tiene que tener el método ${quoted(method)}."

    override fun writePublicMethod(method: String) = "Escríbelo con \"public\" delante, así: public void $method { }"

    override fun mustBePublic(method: String) = "${quoted(method)} tiene que llevar \"public\" delante."

    override fun noMain() = "El ladrillo no sabe por dónde empezar: ninguna clase tiene un método \"main\"."

    override fun wrongMain() =
        "El ladrillo no sabe por dónde empezar, porque este método no está declarado como debe estarlo \"main\"."

    override fun writeMain() = "Escríbelo así: public static void main(String[] args) { }"
}
