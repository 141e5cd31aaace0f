package robotran.robolang.messages

import robotran.language.quoted

/** What a pupil is told in Spanish when a program cannot go on. */
internal object SpanishRunMessages : RunMessages {
    override fun divisionByZero(dividend: String) = "$dividend no se puede dividir entre 0."

    override fun indexOutside(index: Int, size: Int) = when (size) {
        0 -> "No hay ningún elemento $index, porque la lista está vacía."
        1 -> "No hay ningún elemento $index en una lista de 1, solo el elemento 0."
        else -> "No hay ningún elemento $index en una lista de $size. Se cuentan del 0 al ${size - 1}."
    }

    override fun tooManyCalls(name: String, limit: Int) =
        "${quoted(name)} se llama a sí mismo demasiadas veces: en la memoria de un ladrillo no caben más de $limit " +
            "llamadas unas dentro de otras."

    override fun listsTooLarge(limit: Int) =
        "La memoria del ladrillo está llena: todas las listas hechas hasta ahora tienen más de $limit elementos, y " +
            "los guarda todos."

    override fun negativeTime(value: String) = "El robot no puede esperar $value. Usa 0 o más."

    override fun negativeCount(value: Int) = "Nada se puede repetir $value veces. Usa 0 o más."

    override fun powerOutside(value: Int) = "Un motor no tiene potencia $value, solo de 0 a 7."

    override fun stepOfNothing() = "Con pasos de 0, el bucle no avanzaría nunca."

    override fun rootOfNegative(value: String) = "$value no tiene raíz cuadrada, porque es menor que 0."

    override fun powerOfNegative(base: String, exponent: String) =
        "No existe ningún número que sea $base elevado a $exponent."

    override fun nothingReturned(name: String) =
        "La función ${quoted(name)} ha llegado a su final sin ningún \"return\"."
}
