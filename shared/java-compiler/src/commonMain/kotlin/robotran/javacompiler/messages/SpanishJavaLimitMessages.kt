package robotran.javacompiler.messages

import robotran.language.quoted

internal object SpanishJavaLimitMessages : JavaLimitMessages {
    override fun sourceTooLong(limit: String) =
        "Un programa puede tener como mucho $limit letras y signos y 100 archivos. No se ha leído nada de él."

    override fun nestedTooDeeply() =
        "Aquí hay demasiadas cosas unas dentro de otras. Usa un método o una variable para una parte."

    override fun tooManyImports(limit: String) =
        "Un archivo puede tener como mucho $limit \"import\". Uno que acaba en \".*\" vale para todas las clases " +
            "de un paquete."

    override fun tooManyClasses(limit: String) = "Un programa puede tener como mucho $limit clases."

    override fun finallyCopiedTooOften() =
        "El compilador copia lo que hay en un \"finally\" en cada final de su \"try\". Aquí salen demasiadas copias " +
            "de copias."

    override fun useMethodInFinally() = "Pon lo que hay en este \"finally\" en un método y llámalo aquí."

    override fun tooMuchWork(name: String) = "El compilador tardaría demasiado con ${quoted(name)}."

    override fun putLessInside() = "Divídelo en varias partes y pon menos cosas unas dentro de otras."

    override fun methodTooLong() =
        "De aquí salen más instrucciones de las que caben en un método, que son 65535 bytes. Divídelo en varios " +
            "métodos."
}
