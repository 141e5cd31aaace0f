package robotran.tinyvm.messages

import robotran.tinyvm.config.Quirk

/**
 * The Spanish messages. Each term has one translation: array - array, brick - ladrillo, class - clase, field - campo,
 * method - método, memory - memoria, thread - hilo.
 */
object SpanishTinyVmMessages :
    TinyVmMessages,
    ClassFileMessages by SpanishClassFileMessages,
    LinkMessages by SpanishLinkMessages,
    RunMessages by SpanishVmRunMessages

private object SpanishClassFileMessages : ClassFileMessages {
    override fun notAClassFile() = "Este no es un archivo de clase: compila el programa otra vez."

    override fun classFileTooLong(limit: Int) =
        "Este archivo de clase tiene más de $limit bytes. En un ladrillo cabe mucho menos."

    override fun classFileTooNew() =
        "Esta clase se ha compilado para un Java más nuevo que el que entiende un ladrillo. Compílala con --release " +
            "8, o abre aquí su texto."

    override fun classFileDamaged() = "Este archivo de clase está dañado: compila el programa otra vez."
}

private object SpanishLinkMessages : LinkMessages {
    override fun noMainMethod() =
        "No hay nada por donde empezar: escribe en una clase un método \"public static void main(String[] args)\"."

    override fun classMissing(name: String) = "En el ladrillo no existe la clase $name."

    override fun fieldMissing(className: String, name: String) = when (className to name) {
        "java.lang.System" to "out" -> {
            "El ladrillo no tiene System.out. Muestra los textos con TextLCD.print y los números con LCD.showNumber."
        }

        else -> "En el ladrillo, $className no tiene \"$name\"."
    }

    override fun methodMissing(className: String, name: String) =
        "En el ladrillo, $className no tiene ningún método \"$name\"."

    override fun duplicateClass(name: String) = "Hay dos clases que se llaman $name. Dale otro nombre a una de ellas."

    override fun cyclicInheritance(name: String) = "La clase $name no puede extenderse a sí misma."

    override fun tooMany(counted: Counted, limit: Int) = "En un ladrillo caben como mucho $limit ${nameOf(counted)}."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "Este programa ocupa unos $bytes bytes de la memoria del ladrillo, pero solo caben $limit. Usa menos clases " +
            "de leJOS o escribe menos código."

    override fun nativeMethod(name: String) =
        "El ladrillo no trae ningún método \"$name\". Escríbelo en Java, sin \"native\"."

    override fun unsupportedFeature(feature: UnsupportedFeature) = when (feature) {
        UnsupportedFeature.SWITCH -> "El ladrillo no conoce \"switch\". Usa \"if\" y \"else if\"."

        UnsupportedFeature.LONG_ARITHMETIC -> {
            "El ladrillo no puede calcular con números long ni compararlos. Conviértelos antes en int: (int) time."
        }

        UnsupportedFeature.DECIMAL_REMAINDER -> "El ladrillo solo conoce % para números enteros."
        UnsupportedFeature.FAR_JUMP -> "Este método es demasiado largo para el ladrillo. Pasa partes a otros métodos."
        UnsupportedFeature.MANY_LOCALS -> "En el ladrillo, un método puede tener como mucho 255 variables."

        UnsupportedFeature.MANY_CONSTANTS -> {
            "Esta clase tiene demasiados textos distintos y números grandes para el ladrillo. Pasa algunos a otra " +
                "clase."
        }

        UnsupportedFeature.INVOKE_DYNAMIC -> {
            "El ladrillo no conoce las lambdas ni las formas nuevas de unir textos. Compila para un Java más " +
                "antiguo, o escribe una clase."
        }

        UnsupportedFeature.ARRAY_TEST -> {
            "El ladrillo no puede comprobar ni convertir arrays. Guarda el array en una variable de su propio tipo."
        }

        UnsupportedFeature.CLASS_LITERAL -> "En el ladrillo las clases no son objetos: no existe \".class\"."
        UnsupportedFeature.INTERFACE_CODE -> "En el ladrillo, una interfaz solo nombra métodos y no contiene código."

        UnsupportedFeature.NESTED_FINALLY -> {
            "Aquí hay demasiados bloques \"finally\" unos dentro de otros. Pasa algunos a otros métodos."
        }
    }

    override fun codeInvalid() =
        "Este archivo de clase está dañado y su código no tiene sentido: compila el programa otra vez."

    private fun nameOf(counted: Counted) = when (counted) {
        Counted.CLASSES -> "clases en un programa, contando las de leJOS"
        Counted.ARRAY_TYPES -> "tipos de arrays en un programa"
        Counted.FIELDS -> "campos en una clase"
        Counted.METHODS -> "métodos en una clase"
        Counted.LOCALS -> "variables en un método"
        Counted.OPERANDS -> "valores dentro de un cálculo"
        Counted.PARAMETERS -> "parámetros de un método, contando \"this\", y dos veces long y double"
        Counted.HANDLERS -> "\"catch\" y \"finally\" en un método"
        Counted.CODE_BYTES -> "bytes de código en un método"
        Counted.TEXT_CHARACTERS -> "letras y signos en un texto"
        Counted.ANCESTORS -> "clases e interfaces por encima de una clase"
    }
}

private object SpanishVmRunMessages : RunMessages {
    override val nxt = SpanishNxtRunMessages

    override fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        val digit = exceptionNumber % 10
        val number = if (digit == exceptionNumber) "$digit" else "$digit, la última cifra de $exceptionNumber"
        return "Nadie ha atrapado esta excepción: $said. Un ladrillo zumba y muestra $methodNumber y $number."
    }

    override fun quirkEffect(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Un ladrillo solo divide entre números de -32768 a 32767. De un divisor mayor pierde el resto."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Un ladrillo solo mira 16 bits de un índice, así que uno grande acierta en otro elemento."
        }

        Quirk.SIGNED_CHARACTER -> "En un ladrillo, un char mayor que 32767 se vuelve negativo."

        Quirk.UNCHECKED_INTERFACE -> {
            "En un ladrillo, cualquier objeto vale por cualquier interfaz: esta comprobación o conversión no se ha " +
                "hecho de verdad."
        }

        Quirk.LONG_ARRAY -> "En un ladrillo, un array tiene como mucho 511 elementos."

        Quirk.HEAP_FULL -> {
            "La memoria del ladrillo está llena. Nunca devuelve memoria, así que haz los objetos, arrays y textos " +
                "una sola vez y " +
                "úsalos de nuevo."
        }

        Quirk.NOT_A_NUMBER -> {
            "Este número decimal no es ningún número, y un ladrillo lo toma por igual a todos los demás."
        }

        Quirk.JOIN_DOES_NOTHING -> "En un ladrillo, join no espera. Pregunta con isAlive en un bucle."

        Quirk.UNLOCKED_METHOD -> {
            "Un ladrillo no bloquea nada en un método synchronized que es private o static, o que se llama con " +
                "super: wait y notify fallan en él, y otros hilos pueden entrar. No lo hagas private ni static."
        }

        Quirk.DEEP_ARRAY -> {
            "Un ladrillo no puede crear de una vez un array de tres o más dimensiones: lanza un OutOfMemoryError. " +
                "Crea los arrays interiores en un bucle."
        }

        Quirk.DEEP_CALLS -> {
            "Un ladrillo tiene sitio para unas 210 llamadas una dentro de otra, y para menos si tienen muchas " +
                "variables o si su memoria está llena."
        }

        Quirk.LATE_INITIALIZER -> {
            "Un ladrillo prepara los campos estáticos de una clase cuando se usa por primera vez esa misma clase, " +
                "así que aquí los de la superclase aún no están listos."
        }

        Quirk.EARLY_HANDLER -> {
            "En un ladrillo, un try también se ocupa de lo que falla en la instrucción que está justo antes. Pon " +
                "otra instrucción en medio, por ejemplo int next = 0;"
        }

        Quirk.NEGATIVE_TIME -> {
            "Un ladrillo no hace ninguna pausa con un tiempo menor que 0, y no lanza ninguna excepción."
        }

        Quirk.NEGATIVE_LONG -> {
            "Un ladrillo toma un long negativo por un número positivo grande cuando se convierte en decimal. " +
                "Conviértelo antes en int: (int) time."
        }

        Quirk.UNCHECKED_ELEMENT -> {
            "Un ladrillo no comprueba lo que guardas en un array. Este objeto es de otra clase, y de eso no sale " +
                "nada bueno: aquí se guarda null en su lugar."
        }

        Quirk.LOST_EXCEPTION -> {
            "Después de una conversión o un array nuevo que fallan, un ladrillo no da la excepción a catch: la " +
                "variable es null o conserva lo que tenía antes. No la uses ahí."
        }
    }

    override fun programMemoryUse(programBytes: Int, allBytes: Int) =
        "De sus $allBytes bytes, el propio programa ocupa unos $programBytes."

    override fun quirkWarning(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Un ladrillo de verdad solo tomaría 16 bits de este divisor y le saldría otro resultado."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Un ladrillo de verdad solo tomaría 16 bits de este índice y podría acertar en otro elemento."
        }

        Quirk.SIGNED_CHARACTER -> "En un ladrillo de verdad, este char se volvería negativo."
        Quirk.UNCHECKED_INTERFACE -> "Un ladrillo de verdad no notaría que el objeto no cumple esta interfaz."

        Quirk.LONG_ARRAY -> {
            "Un ladrillo de verdad no tiene arrays de más de 511 elementos: lanzaría un OutOfMemoryError."
        }

        Quirk.HEAP_FULL -> "La memoria de un ladrillo de verdad ya estaría llena: nunca devuelve memoria."
        Quirk.NOT_A_NUMBER -> "Un ladrillo de verdad lo tomaría por igual a todos los demás números."
        Quirk.JOIN_DOES_NOTHING -> "En un ladrillo de verdad, join no espera, así que aquí tampoco."

        Quirk.UNLOCKED_METHOD -> {
            "Un ladrillo de verdad no bloquearía nada aquí: pasa por alto \"synchronized\" en un método que es " +
                "private o static, o que se llama con super."
        }

        Quirk.DEEP_ARRAY -> {
            "Un ladrillo de verdad no puede crear de una vez un array de tres o más dimensiones: lanzaría un " +
                "OutOfMemoryError."
        }

        Quirk.DEEP_CALLS -> {
            "Un ladrillo de verdad tiene sitio para unas 210 llamadas una dentro de otra, y para menos con muchas " +
                "variables: lanzaría un StackOverflowError."
        }

        Quirk.LATE_INITIALIZER -> {
            "Un ladrillo de verdad aún no habría preparado aquí los campos estáticos de la superclase: lo hace " +
                "cuando se usa por primera vez esa misma clase."
        }

        Quirk.EARLY_HANDLER -> {
            "En un ladrillo de verdad, el try que sigue a esta instrucción también se ocuparía de esto. Pon otra " +
                "instrucción en medio, por ejemplo int next = 0;"
        }

        Quirk.NEGATIVE_TIME -> "Un ladrillo de verdad no haría aquí ninguna pausa ni lanzaría ninguna excepción."
        Quirk.NEGATIVE_LONG -> "Un ladrillo de verdad tomaría este long negativo por un número positivo grande."

        Quirk.UNCHECKED_ELEMENT -> {
            "Un ladrillo de verdad no notaría que este objeto es de otra clase que los elementos del array."
        }

        Quirk.LOST_EXCEPTION -> {
            "Un ladrillo de verdad no daría esta excepción a catch: la variable sería null o conservaría lo que " +
                "tenía antes."
        }
    }
}
