package robotran.robolang.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted

/**
 * The messages in Spanish. They address the pupil as "tú". Each term has one translation: brick - ladrillo, bracket -
 * paréntesis, command - orden, condition - condición, declare - declarar, display - pantalla, digit - cifra, line -
 * línea, loop - bucle, power - potencia, text - texto, value - valor, whole number - número entero, decimal number -
 * número decimal. Words of Robolang are quoted and not translated.
 */
object SpanishRobolangMessages :
    RobolangMessages,
    SyntaxMessages by SpanishSyntaxMessages,
    MeaningMessages by SpanishMeaningMessages,
    WarningMessages by SpanishWarningMessages,
    BrickKindMessages by SpanishBrickKindMessages,
    RunMessages by SpanishRunMessages

/** The messages about syntax errors in Spanish. */
private object SpanishSyntaxMessages : SyntaxMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "No existe la orden ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingCommand() = "Una línea empieza por una orden, como \"forward 20\"."

    override fun missingSpace(word: String, number: String) =
        "Pon un espacio entre ${quoted(word)} y ${quoted(number)}."

    override fun missingNumber(command: String, example: String) =
        "Después de ${quoted(command)} va un número, como en ${quoted(example)}."

    override fun startInstead(start: String) = "Para que conduzca hasta que pase algo, escribe ${quoted(start)}."

    override fun missingTurnDirection(suggestion: String?) =
        "Di hacia dónde hay que girar: \"turn left 90\" o \"turn right 90\".${didYouMean(suggestion)}"

    override fun missingPenPosition(suggestion: String?) =
        "Di si el lápiz baja o sube: \"pen down\" o \"pen up\".${didYouMean(suggestion)}"

    override fun missingTimes(count: String, suggestion: String?) =
        "Después de ${quoted("repeat $count")} va \"times\".${didYouMean(suggestion)}"

    override fun missingTimeUnit(duration: String) =
        "Di cuánto tiempo: ${quoted("wait $duration seconds")} o ${quoted("wait $duration milliseconds")}."

    override fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?) =
        "${quoted(command)} se mide en ${units.joinToString(" o ")}, no en ${quoted(unit)}.${didYouMean(suggestion)}"

    override fun severalCommands(second: String) = "Escribe ${quoted(second)} en otra línea."

    override fun extraWords(extra: String, complete: String) =
        "La línea ya está completa después de ${quoted(complete)}, así que ${quoted(extra)} sobra aquí."

    override fun missingEnd(block: String) =
        "A este ${quoted(block)} le falta su \"end\". Escribe \"end\" en otra línea, donde termina el bloque."

    override fun extraEnd() = "Este \"end\" no cierra ningún bloque."

    override fun unknownCharacter(character: String) = "El signo ${quoted(character)} no significa nada aquí."

    override fun invisibleCharacter(code: String) = "Aquí hay un signo que no se ve ($code). Bórralo."

    override fun pastedCharacter(pasted: PastedCharacter, written: String) = pasted.adviceIn(Language.SPANISH, written)

    override fun characterInsteadOf(written: String, right: String) = writeInstead(written, right)

    override fun commentBegins() = "Un comentario empieza por \"//\"."

    override fun semicolon() = "Una línea no necesita punto y coma."

    override fun numberTooLarge(smallest: Int, largest: Int) =
        "Este número es demasiado grande. Los números van de $smallest a $largest."

    override fun malformedNumber(number: String, right: String?) =
        if (right == null) "${quoted(number)} no es un número." else writeInstead(number, right)

    override fun decimalComma(right: String?) = if (right == null) {
        "Aquí un número lleva punto, no coma."
    } else {
        "Aquí un número lleva punto, no coma. Escribe $right."
    }

    override fun nestedTooDeeply(limit: Int) = "Puede haber como mucho $limit bloques unos dentro de otros."

    override fun sourceTooLong(limit: Int) =
        "Un programa puede tener como mucho $limit letras y signos. Este tiene más."

    override fun unclosedText() = "Un texto termina con unas comillas."

    override fun useTwoEqualsSigns() = "Usa \"==\" para comparar."

    override fun useOneEqualsSign() = "Usa \"=\" para dar su valor a una variable."

    override fun combinedAssignment(name: String, operator: String) =
        "Escribe mejor ${quoted("$name = $name $operator ...")}."

    override fun missingCondition(command: String, example: String) =
        "Después de ${quoted(command)} va una condición, como en ${quoted(example)}."

    override fun missingValue(command: String, example: String) =
        "Después de ${quoted(command)} va un valor, como en ${quoted(example)}."

    override fun missingOperand(before: String) = "Después de ${quoted(before)} falta un valor."

    override fun missingAssignment(before: String, example: String) =
        "Después de ${quoted(before)} van \"=\" y un valor, como en ${quoted(example)}."

    override fun missingName(before: String, example: String) =
        "Después de ${quoted(before)} va un nombre, como en ${quoted(example)}."

    override fun reservedWord(word: String) = "${quoted(word)} es una palabra de Robolang. Elige otro nombre."

    override fun missingBracket(opening: String, closing: String) =
        "A este ${quoted(opening)} le falta su ${quoted(closing)}."

    override fun missingBracketsOfCall(name: String) =
        "Para llamar a ${quoted(name)}, escribe detrás sus valores entre paréntesis, o unos paréntesis vacíos si no " +
            "tiene ninguno."

    override fun missingBracketsOfRoutine(name: String) =
        "Después de ${quoted(name)} van unos paréntesis, con los nombres de sus valores dentro, o vacíos."

    override fun missingWord(before: String, word: String, suggestion: String?) =
        "Después de ${quoted(before)} va ${quoted(word)}.${didYouMean(suggestion)}"

    override fun missingButton(suggestion: String?) =
        "Di qué botón: \"button run\", \"button view\" o \"button prgm\".${didYouMean(suggestion)}"

    override fun missingMove(suggestion: String?) =
        "Di qué debe empezar: \"start forward\", \"start backward\" o \"start turning left\".${didYouMean(suggestion)}"

    override fun missingMotor() = "Di qué motor: A, B o C."

    override fun missingMotorCommand(motor: String, suggestion: String?) =
        "Di qué hace el motor $motor: forward, backward, stop, float o power.${didYouMean(suggestion)}"

    override fun missingFacing(suggestion: String?) =
        "Di hacia dónde mira el sensor de luz: \"facing down\" o \"facing forward\".${didYouMean(suggestion)}"

    override fun lengthAndTime() = "Di hasta dónde o cuánto tiempo, pero no las dos cosas."

    override fun extraElse() = "Este \"else\" no tiene ningún \"if\"."

    override fun notOutermost(word: String) = "Un ${quoted(word)} no puede estar dentro de otro bloque. Sácalo de ahí."

    override fun secondRobot() = "Ya hay un \"robot\". Un programa solo tiene uno."

    override fun unknownSetting() =
        "Entre \"robot\" y \"end\" solo van el ladrillo y sus sensores, como en \"light sensor on 2 facing down\"."

    override fun secondSetting() = "El sensor de luz ya está puesto."

    override fun expressionTooDeep(limit: Int) =
        "Puede haber como mucho $limit paréntesis y operaciones unos dentro de otros. Usa una variable para una parte."

    override fun valueAsCommand(word: String) =
        "${quoted(word)} tiene un valor, pero no hace nada. Úsalo dentro de una orden, como en \"show light\"."

    override fun settingOutsideRobot() = "Esto va entre una línea \"robot\" y su \"end\"."

    override fun colon() = "Una línea no necesita dos puntos."

    override fun brace(brace: String) = "Un bloque no necesita ${quoted(brace)}. Termina en una línea con \"end\"."

    override fun malformedName(name: String) =
        "${quoted(name)} no puede ser un nombre. Un nombre empieza por una letra y tiene letras, cifras y \"_\"."

    override fun nameOfSeveralWords(right: String) = "Un nombre es una sola palabra. Escribe ${quoted(right)}."

    override fun missingComma(second: String) = "Pon una coma delante de ${quoted(second)}."

    override fun textAsValue(text: String) = "Un texto como $text solo se puede mostrar, con \"show\"."
}

/** The messages about semantic errors in Spanish. */
private object SpanishMeaningMessages : MeaningMessages {
    override fun countNotWhole(count: String) = "Un bloque no se puede repetir $count veces. Usa un número entero."

    override fun countNegative(count: String) = "Un bloque no se puede repetir $count veces. Usa 0 o más."

    override fun waitNegative() = "El robot no puede esperar menos que nada. Usa 0 o más."

    override fun durationTooLong() = "Esto duraría más de un día. Usa un número más pequeño."

    override fun unknownVariable(name: String, suggestion: String?) =
        "No existe la variable ${quoted(name)}.${didYouMean(suggestion)}"

    override fun unknownRoutine(name: String, suggestion: String?) =
        "No existe ningún procedimiento ni función ${quoted(name)}.${didYouMean(suggestion)}"

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

/** The warnings in Spanish. */
private object SpanishWarningMessages : WarningMessages {
    override fun unusedVariable(name: String) = "${quoted(name)} no se usa nunca."

    override fun neverReached(word: String) = "Esto no se hace nunca, por el ${quoted(word)} que hay antes."

    override fun busyLoop() =
        "Esto sigue para siempre sin moverse, sin esperar y sin mirar los sensores, y solo tiene ocupado al ladrillo."

    override fun fractionLost(division: String, result: Int) =
        "Al dividir números enteros sale un número entero: ${quoted(division)} es $result. Si quieres más, escribe " +
            "uno de ellos con punto."

    override fun divisorTooLarge(divisor: Int, kept: Int) =
        "El ladrillo solo divide entre números de -32768 a 32767. Toma $divisor por $kept."

    override fun listInLoop() =
        "Esto hace una lista nueva una y otra vez, y el ladrillo nunca recupera su memoria. Haz la lista una sola " +
            "vez, arriba del todo."

    override fun divisorTakenForZero(divisor: Int) =
        "El ladrillo solo divide entre números de -32768 a 32767. Toma $divisor por 0 y se para."

    override fun endlessRecursion(name: String) =
        "${quoted(name)} siempre se llama a sí mismo, así que no llega nunca a su final."
}

/** The messages about runtime errors in Spanish. */
private object SpanishRunMessages : RunMessages {
    override fun divisionByZero(dividend: String) = "$dividend no se puede dividir entre 0."

    override fun indexOutside(index: Int, size: Int) = when (size) {
        0 -> "No hay ningún elemento $index, porque la lista está vacía."
        1 -> "No hay ningún elemento $index en una lista de 1, solo el elemento 0."
        else -> "No hay ningún elemento $index en una lista de $size. Se cuentan del 0 al ${size - 1}."
    }

    override fun tooManyCalls(name: String, limit: Int) =
        "${quoted(name)} se llama a sí mismo demasiadas veces: en la memoria de un ladrillo no caben más de $limit " +
            "llamadas unas dentro de otras."

    override fun listsInUseTooLarge(limit: Int) =
        "La memoria del ladrillo está llena: las listas en uso tienen más de $limit elementos."

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

private fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " ¿Querías decir ${quoted(suggestion)}?"

private fun writeInstead(written: String, right: String) = "Escribe ${quoted(right)} en lugar de ${quoted(written)}."
