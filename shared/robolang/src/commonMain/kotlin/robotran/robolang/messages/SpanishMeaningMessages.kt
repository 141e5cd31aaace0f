package robotran.robolang.messages

import robotran.language.quoted

/** What is told in Spanish about lines that make no sense. */
internal object SpanishMeaningMessages : MeaningMessages {
    override fun countNotWhole(count: String) = "Un bloque no se puede repetir $count veces. Usa un número entero."

    override fun countNegative(count: String) = "Un bloque no se puede repetir $count veces. Usa 0 o más."

    override fun waitNegative() = "El robot no puede esperar menos que nada. Usa 0 o más."

    override fun durationTooLong() = "Esto duraría más de un día. Usa un número más pequeño."

    override fun unknownVariable(name: String, suggestion: String?) =
        "No existe la variable ${quoted(name)}.${spanishDidYouMean(suggestion)}"

    override fun unknownRoutine(name: String, suggestion: String?) =
        "No existe ningún procedimiento ni función ${quoted(name)}.${spanishDidYouMean(suggestion)}"

    override fun usedBeforeDeclaration(name: String, line: Int) =
        "${quoted(name)} no se declara hasta la línea $line. Pon esa línea más arriba."

    override fun declaredTwice(name: String, line: Int) =
        "${quoted(name)} ya está declarado en la línea $line. Elige otro nombre."

    override fun declaredBuiltIn(name: String) = "Robolang ya tiene una función ${quoted(name)}. Elige otro nombre."

    override fun assignedConstant(name: String) =
        "${quoted(name)} es una constante y no cambia nunca. Si debe cambiar, declárala con \"var\"."

    override fun assignedLoopVariable(name: String) =
        "Su \"for\" ya cuenta ${quoted(name)}, así que aquí no se puede cambiar."

    override fun numberNeeded(text: String) = "Aquí hace falta un número, y ${quoted(text)} no lo es."

    override fun wholeNumberNeeded(text: String) =
        "Aquí hace falta un número entero, y ${quoted(text)} es decimal. Usa \"round\"."

    override fun conditionNeeded(text: String) = "Aquí hace falta una condición, y ${quoted(text)} no lo es."

    override fun listNeeded(text: String) = "Aquí hace falta una lista, y ${quoted(text)} no lo es."

    override fun valueNeeded(name: String) =
        "${quoted(name)} es un procedimiento y no da ningún valor. Eso solo lo hace una función."

    override fun decimalForWhole(name: String) =
        "${quoted(name)} está declarada con un número entero, así que no le cabe uno decimal. Declárala con uno " +
            "decimal, como 0.0."

    override fun typeChanged(name: String) = "${quoted(name)} está declarada con un valor de otra clase."

    override fun notComparable() = "Solo se pueden comparar dos números o dos condiciones."

    override fun mixedList(text: String) = "En una lista solo hay números, y ${quoted(text)} no lo es."

    override fun emptyList() = "Una lista necesita al menos un número."

    override fun listTooLong(limit: Int) = "Una lista puede tener como mucho $limit elementos."

    override fun indexOutOfRange(last: Int) = "Esta lista tiene los elementos del 0 al $last."

    override fun indexNegative() = "Los elementos de una lista se cuentan desde 0."

    override fun wrongArgumentCount(name: String, needed: Int, given: Int) =
        "${quoted(name)} recibe ${values(needed)}, no $given."

    override fun functionAsCommand(name: String) =
        "${quoted(name)} da un valor. Úsalo, por ejemplo con \"show $name(...)\"."

    override fun outsideLoop(word: String) = "${quoted(word)} tiene que estar dentro de un bucle."

    override fun outsideRoutine() =
        "\"return\" tiene que estar dentro de un procedimiento o de una función. Para terminar el programa, escribe " +
            "\"halt\"."

    override fun returnWithValue(name: String) =
        "${quoted(name)} es un procedimiento y no da ningún valor. Si debe darlo, escribe \"function\" en lugar de " +
            "\"procedure\"."

    override fun returnWithoutValue(name: String) =
        "${quoted(name)} es una función. Di qué valor da, como en \"return 5\"."

    override fun missingReturn(name: String) =
        "${quoted(name)} es una función, pero puede llegar a su final sin \"return\" y un valor."

    override fun durationNegative() = "Nada puede durar menos que nada. Usa 0 o más."

    override fun powerOutOfRange() = "La potencia de un motor va de 0 a 7."

    override fun textTooLong(limit: Int) = "En la pantalla caben $limit letras."

    override fun textNotShown(character: String) =
        "La pantalla no puede mostrar ${quoted(character)}. Tiene letras, cifras, espacios, \"-\" y \"_\"."

    override fun divisionByZero() = "Nada se puede dividir entre 0."

    override fun stepZero() = "Con un paso de 0, esto no terminaría nunca."

    override fun tooManyVariables(limit: Int) = "En el ladrillo caben aquí $limit variables. Esta es una más."

    override fun tooManyParameters(limit: Int) =
        "En el ladrillo caben $limit valores entre paréntesis. Este es uno más."

    override fun tooManyConstants(limit: Int) =
        "En el ladrillo caben $limit números grandes o decimales y textos distintos. Este es uno más."

    override fun tooManyRoutines(limit: Int) =
        "En el ladrillo caben $limit procedimientos y funciones. Este es uno más."

    override fun undeclaredVariable(name: String) =
        "Todavía no existe la variable ${quoted(name)}. Escribe \"var\" delante para declararla."

    override fun calledBeforeDeclaration(routine: String, variable: String, line: Int) =
        "${quoted(routine)} usa ${quoted(variable)}, que no se declara hasta la línea $line. Pon esa línea más arriba."

    override fun calledInDeclaration(routine: String, variable: String) =
        "${quoted(routine)} usa ${quoted(variable)}, que recibe su primer valor justo aquí."

    override fun neededBeforeDeclaration(variable: String, line: Int) =
        "Un \"whenever\" puede necesitar ${quoted(variable)} enseguida, pero no se declara hasta la línea $line. Pon " +
            "esa línea arriba del todo."

    override fun redeclared(name: String, line: Int) =
        "${quoted(name)} ya está declarada en la línea $line. Para cambiarla, quita \"var\"."

    override fun chainedComparison(right: String) = "Compara dos veces: ${quoted(right)}."

    private fun values(count: Int) = if (count == 1) "1 valor" else "$count valores"
}
