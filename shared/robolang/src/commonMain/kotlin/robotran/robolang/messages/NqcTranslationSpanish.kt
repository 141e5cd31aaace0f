package robotran.robolang.messages

import robotran.language.quoted

/** The messages in Spanish, with the terms of [SpanishRobolangMessages]. */
object SpanishNqcTranslationMessages : NqcTranslationMessages {
    override fun otherBrick() = "NQC es para un RCX, pero esto es para un NXT."

    override fun decimal() =
        "NQC no tiene números decimales. Solo puede pasarlos donde están escritos tras forward, turn, wait o play, o " +
            "comparados con timer o battery."

    override fun list() = "Las listas no se pueden pasar a NQC."

    override fun numberTooLarge(number: Int) =
        "$number es demasiado grande para NQC. Sus números van de -32768 a 32767."

    override fun text() = "El firmware de LEGO no puede mostrar textos, solo números."

    override fun clearScreen() = "El firmware de LEGO no puede borrar su pantalla. En su lugar muestra el reloj."

    override fun button() = "Un programa para el firmware de LEGO no puede leer los botones."

    override fun whenever() = "whenever no se puede pasar a NQC. Escribe ahí una tarea con acquire."

    override fun recursion(name: String) =
        "${quoted(name)} se llama a sí mismo, y el firmware de LEGO no puede hacerlo."

    override fun builtIn(name: String) = "NQC no tiene ninguna función ${quoted(name)}."

    override fun unknownStep() = "Para NQC el paso de un bucle tiene que estar escrito como número."

    override fun tooLong() = "El firmware de LEGO puede esperar como máximo 327 segundos seguidos."

    override fun alwaysCalled() = "En NQC se llama a esta función aunque el lado izquierdo de and u or ya decida."
}
