package robotran.javacompiler.messages

internal object SpanishBrickMessages : UnsupportedOnBrickMessages {
    override fun newerJava(what: NewerJava) = "El Java del ladrillo es más antiguo y no tiene ${name(what)}."

    override fun insteadOf(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> {
            "Quita el \"<...>\". Cuando saques algo, escribe su tipo delante: (String) list.elementAt(0)."
        }

        NewerJava.FOR_EACH -> "Mejor cuenta: for (int i = 0; i < values.length; i++)."
        NewerJava.VARARGS -> "Usa un array, como int[]."
        NewerJava.ANNOTATION -> "Quítala."
        NewerJava.ENUM -> "Usa números con nombre: static final int RED = 0, GREEN = 1;"
        NewerJava.STATIC_IMPORT -> "Importa la clase y escribe su nombre delante del método."
        NewerJava.INTERFACE_METHOD_BODY -> "Escribe el método en una clase."
        NewerJava.LAMBDA -> "Escribe una clase para eso, como new Thread() { public void run() { ... } }."
        NewerJava.MULTI_CATCH -> "Escribe un \"catch\" para cada una."
        NewerJava.TRY_WITH_RESOURCES -> "Escribe la instrucción delante del \"try\"."
        NewerJava.SWITCH_EXPRESSION -> "Usa \"if\" y \"else\"."
        NewerJava.AUTOBOXING -> "Usa \"int\", o \"new Integer(...)\" para meter un número en un Vector."
        NewerJava.DIAMOND -> "Escribe los tipos dentro, por ejemplo new ArrayList<String>()."
        NewerJava.TEXT_IN_SWITCH -> "Usa \"if\" y \"equals\": if (palabra.equals(\"ya\"))."
        NewerJava.ASSERT -> "Usa \"if\"."
        NewerJava.VAR -> "Escribe el tipo, como \"int\"."
        NewerJava.TEXT_BLOCK -> "Escribe el texto entre dos comillas, en una sola línea."
        NewerJava.NUMBER_STYLE -> "Escribe el número solo con cifras."
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
        NewerJava.DIAMOND -> "\"<>\" vacío"
        NewerJava.TEXT_IN_SWITCH -> "\"switch\" con un texto"
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

        UnsupportedOnBrick.COLLECTIONS -> "Usa un array, como int[], o un Vector de java.util."

        UnsupportedOnBrick.VECTOR_METHODS -> {
            "El Vector de un ladrillo tiene addElement(), elementAt(), setElementAt(), removeElementAt() y size()."
        }

        UnsupportedOnBrick.HASHTABLE_METHODS -> {
            "Una Hashtable en el ladrillo tiene put() y get(), y get() da null para lo que no está en ella."
        }

        UnsupportedOnBrick.RUNNABLE -> "Escribe en su lugar \"extends Thread\", con un método \"public void run()\"."

        UnsupportedOnBrick.FORMATTING -> {
            "El ladrillo no puede dar formato a los textos. Muestra un número con LCD.showNumber(7)."
        }

        UnsupportedOnBrick.TEXT_METHODS -> {
            "Un texto en el ladrillo tiene length(), charAt(), toCharArray() y equals(), y poco más."
        }

        UnsupportedOnBrick.PARSING -> "El ladrillo no puede leer números de los textos."
        UnsupportedOnBrick.WRAPPERS -> "Usa directamente boolean, char, int o float."

        UnsupportedOnBrick.WRITING_NUMBERS -> {
            "Integer.toString(number) hace un texto de un número entero. LCD.showNumber(number) lo muestra sin hacerlo."
        }

        UnsupportedOnBrick.SYSTEM_METHODS -> "System.currentTimeMillis() es la hora, y la memoria no se recupera nunca."
        UnsupportedOnBrick.ARRAY_COPYING -> "Copia los elementos uno tras otro en un \"for\"."
        UnsupportedOnBrick.WAITING -> "Thread.sleep(1000) espera un segundo."
        UnsupportedOnBrick.FILES -> "El ladrillo no tiene archivos."

        UnsupportedOnBrick.WINDOWS -> {
            "El ladrillo no tiene ventanas. Muestra números y textos cortos con LCD y TextLCD."
        }

        UnsupportedOnBrick.MOTOR_DIRECTIONS -> {
            "Un motor tiene forward(), backward() y stop(), por ejemplo Motor.A.forward();"
        }

        UnsupportedOnBrick.MOTOR_TIME -> {
            "Un motor de un RCX no cuenta grados. Déjalo girar un tiempo: forward(), Thread.sleep(500), stop()"
        }

        UnsupportedOnBrick.MOTOR_POWER -> "Un motor tiene setPower(), de 0 a 7."

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
