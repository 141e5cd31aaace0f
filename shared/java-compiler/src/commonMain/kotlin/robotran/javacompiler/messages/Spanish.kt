package robotran.javacompiler.messages

import robotran.language.quoted
import robotran.lejoslibrary.LejosRemedy

/**
 * The messages in Spanish. They address the pupil as "tú". Glossary: array - array, braces - llaves, brackets -
 * paréntesis, brick - ladrillo, class - clase, declare - declarar, field - campo, loop - bucle, method - método, text -
 * texto, type - tipo, value - valor.
 */
object SpanishJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by SpanishJavaSyntaxMessages,
    JavaNameMessages by SpanishJavaNameMessages,
    JavaSemanticMessages by SpanishJavaSemanticMessages,
    JavaClassMessages by SpanishJavaClassMessages,
    UnsupportedOnBrickMessages by SpanishBrickMessages,
    LejosMessages by SpanishLejosMessages

private object SpanishJavaSyntaxMessages : JavaSyntaxMessages {
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

    override fun sourceTooLong(limit: String) =
        "Un programa puede tener como mucho $limit letras y signos y 100 archivos. No se ha leído nada de él."

    override fun nestedTooDeeply() =
        "Aquí hay demasiadas cosas unas dentro de otras. Usa un método o una variable para una parte."

    override fun compilerFailed() =
        "El compilador no ha podido con este programa. Quita lo último que has cambiado y prueba otra vez."
}

private object SpanishJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "No existe la clase ${quoted(name)}."

    override fun unknownVariable(name: String) = "No existe la variable ${quoted(name)}."

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

    override fun writeMethod(name: String) = "Escribe el método: static void $name() { }"

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

private object SpanishJavaSemanticMessages : JavaSemanticMessages {
    override fun doesNotFit(given: String, needed: String) =
        "Esto es de tipo ${quoted(given)}, y aquí hace falta ${quoted(needed)}."

    override fun castNumber(type: String) =
        "Escribe \"($type)\" delante, y ponlo todo entre paréntesis, si no importa que se pierda una parte."

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

    override fun wrongArguments(method: String, needed: String, given: String) =
        "${quoted(method)} recibe ${inBrackets(needed)}, no ${inBrackets(given)}."

    override fun staticNeeded(name: String) =
        "${quoted(name)} pertenece a un objeto, y en un método \"static\" no hay ninguno."

    override fun makeItStatic() = "Escribe \"static\" delante, donde se declara."

    override fun objectNeeded(name: String, owner: String) =
        "${quoted(name)} necesita un objeto de ${quoted(owner)}, no la clase."

    override fun neverChanges(name: String) = "${quoted(name)} es \"final\", así que solo recibe valor una vez."

    override fun numberTooLarge(number: String) =
        "$number es demasiado grande. Un \"int\" va de -2147483648 a 2147483647."

    override fun noEffect() = "Esto no cambia nada."

    override fun emptyStatement() = "Este \";\" es todo lo que se hace aquí. Quítalo si después viene un bloque."

    override fun wrongOperator(operator: String, types: String) =
        "${quoted(operator)} no funciona con ${quoted(types)}."

    private fun inBrackets(types: String) = if (types.isEmpty()) "ningún valor" else "($types)"
}

private object SpanishJavaClassMessages : JavaClassMessages {
    override fun wrongFileName(className: String) =
        "Una clase pública está en un archivo con su mismo nombre. Llama al archivo ${quoted("$className.java")}, o " +
            "a la clase como al archivo."

    override fun missingReturnType() = "Este método no dice de qué tipo es lo que devuelve."

    override fun writeVoid() = "Escribe \"void\" delante de su nombre, si no devuelve nada."

    override fun cannotInstantiate(name: String) =
        "Java no puede crear un ${quoted(name)} con \"new\", porque le falta una parte por escribir."

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

private object SpanishBrickMessages : UnsupportedOnBrickMessages {
    override fun newerJava(what: NewerJava) = "El Java del ladrillo es más antiguo y no tiene ${name(what)}."

    override fun insteadOf(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> {
            "Quita el \"<...>\". Cuando saques algo, escribe su tipo delante: (String) list.elementAt(0)."
        }

        NewerJava.FOR_EACH -> {
            "Mejor cuenta: for (int i = 0; i < values.length; i++)."
        }

        NewerJava.VARARGS -> {
            "Usa un array, como int[]."
        }

        NewerJava.ANNOTATION -> {
            "Quítala."
        }

        NewerJava.ENUM -> {
            "Usa números con nombre: static final int RED = 0, GREEN = 1;"
        }

        NewerJava.STATIC_IMPORT -> {
            "Importa la clase y escribe su nombre delante del método."
        }

        NewerJava.INTERFACE_METHOD_BODY -> {
            "Escribe el método en una clase."
        }

        NewerJava.LAMBDA -> {
            "Escribe una clase para eso, como new Thread() { public void run() { ... } }."
        }

        NewerJava.MULTI_CATCH -> {
            "Escribe un \"catch\" para cada una."
        }

        NewerJava.TRY_WITH_RESOURCES -> {
            "Escribe la instrucción delante del \"try\"."
        }

        NewerJava.SWITCH_EXPRESSION -> {
            "Usa \"if\" y \"else\"."
        }

        NewerJava.AUTOBOXING -> {
            "Usa \"int\", o \"new Integer(...)\" para meter un número en un Vector."
        }

        NewerJava.ASSERT -> {
            "Usa \"if\"."
        }

        NewerJava.VAR -> {
            "Escribe el tipo, como \"int\"."
        }

        NewerJava.TEXT_BLOCK -> {
            "Escribe el texto entre dos comillas, en una sola línea."
        }

        NewerJava.NUMBER_STYLE -> {
            "Escribe el número solo con cifras."
        }
    }

    private fun name(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> "tipos entre \"<...>\""
        NewerJava.FOR_EACH -> "\"for\" con dos puntos"
        NewerJava.VARARGS -> "\"...\" en un método"
        NewerJava.ANNOTATION -> "anotaciones con \"@\""
        NewerJava.ENUM -> "\"enum\""
        NewerJava.STATIC_IMPORT -> "\"import static\""
        NewerJava.INTERFACE_METHOD_BODY -> "métodos con cuerpo en una interfaz"
        NewerJava.LAMBDA -> "\"->\" ni \"::\""
        NewerJava.MULTI_CATCH -> "\"|\" en un \"catch\""
        NewerJava.TRY_WITH_RESOURCES -> "paréntesis después de \"try\""
        NewerJava.SWITCH_EXPRESSION -> "\"switch\" con un valor"
        NewerJava.AUTOBOXING -> "forma de convertir solo un número en un objeto"
        NewerJava.ASSERT -> "\"assert\""
        NewerJava.VAR -> "\"var\""
        NewerJava.TEXT_BLOCK -> "textos entre tres comillas"
        NewerJava.NUMBER_STYLE -> "\"_\" en los números, ni números que empiecen por \"0b\""
    }

    override fun absent(what: UnsupportedOnBrick) = when (what) {
        UnsupportedOnBrick.PRINTING -> {
            "El ladrillo muestra números con LCD.showNumber(7) y hasta cinco letras con TextLCD.print(\"hello\")."
        }

        UnsupportedOnBrick.KEYBOARD -> {
            "El ladrillo no tiene teclado. Pregunta a sus botones, como Button.VIEW.isPressed()."
        }

        UnsupportedOnBrick.COLLECTIONS -> {
            "Usa un array, como int[], o un Vector de java.util."
        }

        UnsupportedOnBrick.VECTOR_METHODS -> {
            "El Vector de un ladrillo tiene addElement(), elementAt(), setElementAt(), removeElementAt() y size()."
        }

        UnsupportedOnBrick.HASHTABLE_METHODS -> {
            "Una Hashtable en el ladrillo tiene put() y get(), y get() da null para lo que no está en ella."
        }

        UnsupportedOnBrick.RUNNABLE -> {
            "Escribe en su lugar \"extends Thread\", con un método \"public void run()\"."
        }

        UnsupportedOnBrick.FORMATTING -> {
            "El ladrillo no puede dar formato a los textos. Muestra un número con LCD.showNumber(7)."
        }

        UnsupportedOnBrick.TEXT_METHODS -> {
            "Un texto en el ladrillo tiene length(), charAt(), toCharArray() y equals(), y poco más."
        }

        UnsupportedOnBrick.PARSING -> {
            "El ladrillo no puede leer números de los textos."
        }

        UnsupportedOnBrick.WRAPPERS -> {
            "Usa directamente boolean, char, int o float."
        }

        UnsupportedOnBrick.WRITING_NUMBERS -> {
            "Integer.toString(number) hace un texto de un número entero. LCD.showNumber(number) lo muestra sin hacerlo."
        }

        UnsupportedOnBrick.SYSTEM_METHODS -> {
            "System.currentTimeMillis() es la hora, y la memoria no se recupera nunca."
        }

        UnsupportedOnBrick.ARRAY_COPYING -> {
            "Copia los elementos uno tras otro en un \"for\"."
        }

        UnsupportedOnBrick.WAITING -> {
            "Thread.sleep(1000) espera un segundo."
        }

        UnsupportedOnBrick.FILES -> {
            "El ladrillo no tiene archivos."
        }

        UnsupportedOnBrick.WINDOWS -> {
            "El ladrillo no tiene ventanas. Muestra números y textos cortos con LCD y TextLCD."
        }

        UnsupportedOnBrick.OTHER_BRICKS -> {
            "Eso es para ladrillos más nuevos. Las clases de este están en josx.platform.rcx."
        }
    }

    override fun noSwitch() = "El Java del ladrillo no tiene \"switch\"."

    override fun useIf() = "Usa \"if\" y \"else if\"."

    override fun noLongArithmetic() = "El ladrillo no puede calcular con \"long\"."

    override fun useInt() = "Conviértelo antes en \"int\", así: (int) System.currentTimeMillis()."

    override fun noFloatRemainder() = "El ladrillo no tiene \"%\" para \"float\" y \"double\"."

    override fun useIntRemainder() = "Usa \"int\", o resta un número entero de veces aquello entre lo que divides."

    override fun noArrayTypeTest() = "El ladrillo no puede averiguar durante la ejecución si algo es un array."

    override fun useArrayItself() = "Dale a la variable desde el principio el tipo del array, como int[]."

    override fun noClassLiteral() = "El ladrillo no tiene \".class\"."

    override fun useInstanceof() = "Para saber qué es algo, usa \"instanceof\"."

    override fun textJoinedInLoop() =
        "Esto hace un texto nuevo una y otra vez, y el ladrillo nunca recupera su memoria."

    override fun makeTextOnce() = "Hazlo una sola vez, antes del bucle, o muestra números con LCD.showNumber."

    override fun divisorTooLarge(divisor: String, kept: String) =
        "El ladrillo solo divide entre números de -32768 a 32767. Toma $divisor por $kept."

    override fun arrayTooLong(length: String, limit: String) =
        "Un array en el ladrillo tiene como mucho $limit elementos, no $length."
}

private object SpanishLejosMessages : LejosMessages {
    override fun missingInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "En un ladrillo real, leJOS crea cada $owner sin texto."
        LejosRemedy.CHECKED_EXCEPTION -> checkedInLejos(owner)
        LejosRemedy.STRING_BUFFER -> "leJOS en un ladrillo real no tiene $owner."
        LejosRemedy.INTEGER_TO_STRING -> "$owner.$member de leJOS no toma números enteros."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "$owner.$member de leJOS no toma números decimales."
        LejosRemedy.LAST_INDEX_OF -> "Un $owner de leJOS no tiene ${quoted(member)}."
        LejosRemedy.SENSOR_CONSTANTS -> "$owner de leJOS no tiene $member."
        LejosRemedy.SERIAL_PACKETS, LejosRemedy.VECTOR -> "leJOS 2.1 no tiene $owner. Llegó con leJOS 3.0."
        LejosRemedy.LOOP_FROM_THE_END -> "Un $owner de leJOS 2.1 no tiene ${quoted(member)}. Llegó con leJOS 3.0."
        LejosRemedy.LEAVE_OUT -> "Un $owner de leJOS no tiene ${quoted(member)}."
        LejosRemedy.PACKAGE_OF_2_1 -> "leJOS 2.1 tiene $owner en otro paquete."
    }

    override fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> {
            "Escribe \"new $owner()\", o usa Exception o RuntimeException, que pueden tener un texto."
        }

        LejosRemedy.CHECKED_EXCEPTION -> {
            catchException()
        }

        LejosRemedy.STRING_BUFFER -> {
            "StringBuffer puede hacer lo mismo."
        }

        LejosRemedy.INTEGER_TO_STRING -> {
            "Escribe Integer.toString(numero).toCharArray()."
        }

        LejosRemedy.APPEND_TO_STRING_BUFFER -> {
            "Escribe new StringBuffer(20).append(numero).getChars()."
        }

        LejosRemedy.LAST_INDEX_OF -> {
            "Calcúlalo: stack.size() - stack.lastIndexOf(object)."
        }

        LejosRemedy.SENSOR_CONSTANTS -> {
            "Escribe SensorConstants.$member."
        }

        LejosRemedy.SERIAL_PACKETS -> {
            "Envía un paquete de dos bytes con Serial.sendPacket y recíbelo con Serial.readPacket."
        }

        LejosRemedy.VECTOR -> {
            "Allí, usa un Vector con addElement, elementAt, removeElementAt e isEmpty."
        }

        LejosRemedy.LOOP_FROM_THE_END -> {
            "Allí, recorre los elementos desde el último hasta el primero."
        }

        LejosRemedy.LEAVE_OUT -> {
            "Quítalo: no hace nada."
        }

        LejosRemedy.PACKAGE_OF_2_1 -> {
            "Allí, impórtalo de josx.platform.rcx.remotecontrol."
        }
    }

    override fun builderOfCompiler() =
        "Un compilador más nuevo lo usa en cada \"+\" de textos. \"javac -source 1.3 -target 1.1\" de un JDK hasta " +
            "el 8 no, y Robotran compila él mismo los archivos de Java."

    override fun checkedInLejos(name: String) = "En un ladrillo real, cada $name se tiene que anunciar con \"throws\"."

    override fun catchException() = "Captura Exception en su lugar."

    override fun unlockedMethod(name: String, modifier: String) =
        "Un ladrillo no bloquea nada para un método con ${quoted(modifier)}, así que allí ${quoted(name)} no es " +
            "synchronized."

    override fun monitorCallFails(method: String) =
        "Si no está ya bloqueado, ${quoted(method)} acaba allí con una IllegalMonitorStateException."

    override fun lockWithoutPrivate() = "Quita \"private\", o pon todo lo que contiene en synchronized (this) { ... }."

    override fun lockAnObject() =
        "Da a la clase \"static final Object LOCK = new Object();\" y pon todo lo del método en " +
            "synchronized (LOCK) { ... }."

    override fun unlockedSuperCall(name: String) =
        "Un ladrillo no bloquea nada para una llamada con \"super\", así que aquí ${quoted(name)} no es synchronized."

    override fun lockThis() = "Pon la llamada en synchronized (this) { ... }."

    override fun textAndNumber() =
        "En un ladrillo real, puede que un número no quepa detrás de un texto: leJOS no le hace sitio, y una " +
            "excepción acaba el programa."

    override fun makeRoomForNumber() =
        "Muestra el número con LCD.showNumber, o haz sitio: new StringBuffer(20).append(\"x\").append(7).toString()."
}
