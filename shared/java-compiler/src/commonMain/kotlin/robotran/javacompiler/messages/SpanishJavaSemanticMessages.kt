package robotran.javacompiler.messages

import robotran.language.quoted

internal object SpanishJavaSemanticMessages : JavaSemanticMessages {
    override fun doesNotFit(given: String, needed: String) =
        "Esto es de tipo ${quoted(given)}, y aquí hace falta ${quoted(needed)}."

    override fun castNumber(type: String) =
        "Escribe \"($type)\" delante, y ponlo todo entre paréntesis, si no importa que se pierda una parte."

    override fun notWhole(number: String, type: String) =
        "$number tiene un punto, y en ${quoted(type)} solo caben números enteros."

    override fun writeWhole(number: String) = "Escribe un número entero, por ejemplo $number."

    override fun writeWholeOrDeclare(number: String, declaration: String) =
        "Escribe un número entero, por ejemplo $number. Para números con punto, declara así la variable: $declaration"

    override fun tooLargeFor(number: String, type: String) = "$number no cabe en ${quoted(type)}."

    override fun declareAsInt() = "Declara la variable como \"int\"."

    override fun castObject(type: String) = "Escribe \"($type)\" delante, si sabes que lo es."

    override fun writeFloat(number: String) = "Escribe \"${number}f\"."

    override fun compareWithTwoSigns() = "Para comparar, escribe \"==\". Un solo \"=\" da valor a una variable."

    override fun compareWithZero() = "Una condición es verdadera o falsa. Compara el número con algo, así: count > 0"

    override fun makeText() = "Integer.toString(...) alrededor de un número entero lo convierte en un texto."

    override fun givesNothing() = "Este método es \"void\", así que no devuelve nada que se pueda usar aquí."

    override fun notInitialized(name: String) =
        "Puede que ${quoted(name)} todavía no tenga valor. Dale uno donde se declara."

    override fun declaredTwice(name: String) =
        "${quoted(name)} ya está declarada. Elige otro nombre, o quita su tipo si quieres darle otro valor."

    override fun returnsNothing() =
        "Este método es \"void\", así que no devuelve nada. Escribe \"return;\" o cambia su tipo."

    override fun mustReturn() = "Este método tiene que devolver un valor por cualquiera de sus caminos."

    override fun returnValue() =
        "Escribe \"return\" y el valor, también para cuando no se cumple ningún \"if\". Si no hay ninguno que dar, " +
            "ponle \"void\"."

    override fun neverReached() = "El programa no llega nunca hasta aquí, por lo que hay antes."

    override fun unhandledException(name: String) = "Aquí puede ocurrir ${quoted(name)}, y nadie se ocupa de ello."

    override fun handleIt(name: String) =
        "Escribe \"throws $name\" detrás de los paréntesis del método, como en \"main(String[] args) throws $name\", " +
            "o ponlo dentro de " +
            "try { ... } catch ($name e) { }, como tiene que hacerlo un método \"run\"."

    override fun neverThrown(name: String) =
        "Nada en el \"try\" puede llevar a ${quoted(name)}, o ya lo ha atrapado un \"catch\" anterior."

    override fun removeCatch() = "Quita este \"catch\"."

    override fun wrongArguments(method: String, needed: String, given: String) = when {
        given.isEmpty() -> "${quoted(method)} necesita algo entre los paréntesis: $method($needed)"
        needed.isEmpty() -> "${quoted(method)} no lleva nada entre los paréntesis: $method()"
        else -> "${quoted(method)} recibe ($needed), no ($given)."
    }

    override fun staticNeeded(name: String) =
        "${quoted(name)} pertenece a un objeto, y en un método \"static\" no hay ninguno."

    override fun makeItStatic() = "Escribe \"static\" delante, donde se declara."

    override fun objectNeeded(name: String, owner: String) =
        "${quoted(name)} necesita un objeto de ${quoted(owner)}, no la clase."

    override fun neverChanges(name: String) = "${quoted(name)} es \"final\", así que solo recibe valor una vez."

    override fun numberTooLarge(number: String) =
        "$number es demasiado grande. Un \"int\" va de -2147483648 a 2147483647."

    override fun noLeadingZero(number: String) = "Un número entero no empieza por 0 en Java. Escribe $number."

    override fun countsMilliseconds() = "Cuenta milisegundos enteros: medio segundo es 500."

    override fun sleepInstead() = "Para esperar, escribe Thread.sleep(500), que es medio segundo."

    override fun callOnObject(name: String) = "Escribe delante para qué objeto es, así: lock.$name()"

    override fun callOnNew(className: String, name: String) =
        "Crea primero un objeto y llámalo con él: new $className().$name()"

    override fun announcesMore(exception: String, method: String) =
        "Este método sustituye a ${quoted(method)}, que no anuncia ninguna $exception. Así que él tampoco puede."

    override fun catchInside(exception: String) =
        "Quita este \"throws\" y pon lo que puede causarla en try { ... } catch ($exception e) { }."

    override fun noEffect() = "Esto no cambia nada."

    override fun emptyStatement() = "Este \";\" es todo lo que se hace aquí. Quítalo si después viene un bloque."

    override fun wrongOperator(operator: String, types: String) =
        "${quoted(operator)} no funciona con ${quoted(types)}."
}
