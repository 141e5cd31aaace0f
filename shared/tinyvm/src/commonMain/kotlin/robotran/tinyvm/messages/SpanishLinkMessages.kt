package robotran.tinyvm.messages

/** What is said in Spanish of a class that cannot be put on the brick. */
internal object SpanishLinkMessages : LinkMessages {
    override fun noMainMethod() =
        "No hay nada por donde empezar: escribe en una clase un método \"public static void main(String[] args)\"."

    override fun classMissing(name: String) = "En el ladrillo no existe la clase $name."

    override fun fieldMissing(className: String, name: String) = when (className to name) {
        "java.lang.System" to "out" -> {
            "El ladrillo no tiene System.out. Muestra los textos con TextLCD.print y los números con LCD.showNumber."
        }

        else -> {
            "En el ladrillo, $className no tiene \"$name\"."
        }
    }

    override fun methodMissing(className: String, name: String) =
        "En el ladrillo, $className no tiene ningún método \"$name\"."

    override fun classTwice(name: String) = "Hay dos clases que se llaman $name. Dale otro nombre a una de ellas."

    override fun classLoop(name: String) = "La clase $name no puede extenderse a sí misma."

    override fun tooMany(counted: Counted, limit: Int) = "En un ladrillo caben como mucho $limit ${nameOf(counted)}."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "Este programa ocupa unos $bytes bytes de la memoria del ladrillo, pero solo caben $limit. Usa menos clases " +
            "de leJOS o escribe menos código."

    override fun nativeMethod(name: String) =
        "El ladrillo no trae ningún método \"$name\". Escríbelo en Java, sin \"native\"."

    override fun lacks(feature: UnsupportedFeature) = when (feature) {
        UnsupportedFeature.SWITCH -> {
            "El ladrillo no conoce \"switch\". Usa \"if\" y \"else if\"."
        }

        UnsupportedFeature.LONG_ARITHMETIC -> {
            "El ladrillo no puede calcular con números long ni compararlos. Conviértelos antes en int: (int) time."
        }

        UnsupportedFeature.DECIMAL_REMAINDER -> {
            "El ladrillo solo conoce % para números enteros."
        }

        UnsupportedFeature.FAR_JUMP -> {
            "Este método es demasiado largo para el ladrillo. Pasa partes a otros métodos."
        }

        UnsupportedFeature.MANY_LOCALS -> {
            "En el ladrillo, un método puede tener como mucho 255 variables."
        }

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

        UnsupportedFeature.CLASS_LITERAL -> {
            "En el ladrillo las clases no son objetos: no existe \".class\"."
        }

        UnsupportedFeature.INTERFACE_CODE -> {
            "En el ladrillo, una interfaz solo nombra métodos y no contiene código."
        }

        UnsupportedFeature.NESTED_FINALLY -> {
            "Aquí hay demasiados bloques \"finally\" unos dentro de otros. Pasa algunos a otros métodos."
        }
    }

    override fun codeUnsound() =
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
