package robotran.robolang.messages

import robotran.language.quoted

/** What is told in Spanish about lines that cannot be read. */
internal object SpanishSyntaxMessages : SyntaxMessages {
    override fun unknownCommand(word: String, suggestion: String?) =
        "No existe la orden ${quoted(word)}.${spanishDidYouMean(suggestion)}"

    override fun missingCommand() = "Una línea empieza por una orden, como \"forward 20\"."

    override fun missingSpace(word: String, number: String) =
        "Pon un espacio entre ${quoted(word)} y ${quoted(number)}."

    override fun missingNumber(command: String, example: String) =
        "Después de ${quoted(command)} va un número, como en ${quoted(example)}."

    override fun missingTurnDirection(suggestion: String?) =
        "Di hacia dónde hay que girar: \"turn left 90\" o \"turn right 90\".${spanishDidYouMean(suggestion)}"

    override fun missingPenPosition(suggestion: String?) =
        "Di si el lápiz baja o sube: \"pen down\" o \"pen up\".${spanishDidYouMean(suggestion)}"

    override fun missingTimes(count: String, suggestion: String?) =
        "Después de ${quoted("repeat $count")} va \"times\".${spanishDidYouMean(suggestion)}"

    override fun missingTimeUnit(duration: String) =
        "Di cuánto tiempo: ${quoted("wait $duration seconds")} o ${quoted("wait $duration milliseconds")}."

    override fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?) =
        "${quoted(command)} se mide en ${units.joinToString(" o ")}, no en " +
            "${quoted(unit)}.${spanishDidYouMean(suggestion)}"

    override fun severalCommands(second: String) = "Escribe ${quoted(second)} en otra línea."

    override fun extraWords(extra: String, complete: String) =
        "La línea ya está completa después de ${quoted(complete)}, así que ${quoted(extra)} sobra aquí."

    override fun missingEnd(block: String) =
        "A este ${quoted(block)} le falta su \"end\". Escribe \"end\" en otra línea, donde termina el bloque."

    override fun extraEnd() = "Este \"end\" no cierra ningún bloque."

    override fun unknownCharacter(character: String) = "El signo ${quoted(character)} no significa nada aquí."

    override fun invisibleCharacter(code: String) = "Aquí hay un signo que no se ve ($code). Bórralo."

    override fun characterInsteadOf(written: String, right: String) = spanishWriteInstead(written, right)

    override fun commentBegins() = "Un comentario empieza por \"//\"."

    override fun semicolon() = "Una línea no necesita punto y coma."

    override fun numberTooLarge(smallest: Int, largest: Int) =
        "Este número es demasiado grande. Los números van de $smallest a $largest."

    override fun malformedNumber(number: String, right: String?) =
        if (right == null) "${quoted(number)} no es un número." else spanishWriteInstead(number, right)

    override fun decimalComma(right: String?) = if (right ==
        null
    ) {
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
        "Después de ${quoted(before)} va ${quoted(word)}.${spanishDidYouMean(suggestion)}"

    override fun missingButton(suggestion: String?) =
        "Di qué botón: \"button run\", \"button view\" o \"button prgm\".${spanishDidYouMean(suggestion)}"

    override fun missingMove(suggestion: String?) =
        "Di qué debe empezar: \"start forward\", \"start backward\" o \"start turning " +
            "left\".${spanishDidYouMean(suggestion)}"

    override fun missingMotor() = "Di qué motor: A, B o C."

    override fun missingMotorCommand(motor: String, suggestion: String?) =
        "Di qué hace el motor $motor: forward, backward, stop, float o power.${spanishDidYouMean(suggestion)}"

    override fun missingFacing(suggestion: String?) =
        "Di hacia dónde mira el sensor de luz: \"facing down\" o \"facing forward\".${spanishDidYouMean(suggestion)}"

    override fun portOutOfRange() = "Los sensores son el 1, el 2 y el 3, como en \"sensor 2\"."

    override fun lengthAndTime() = "Di hasta dónde o cuánto tiempo, pero no las dos cosas."

    override fun extraElse() = "Este \"else\" no tiene ningún \"if\"."

    override fun notOutermost(word: String) = "Un ${quoted(word)} no puede estar dentro de otro bloque. Sácalo de ahí."

    override fun secondRobot() = "Ya hay un \"robot\". Un programa solo tiene uno."

    override fun unknownSetting() =
        "Entre \"robot\" y \"end\" solo va el sensor de luz, como en \"light sensor on 2 facing down\"."

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

    override fun missingComma(second: String) = "Pon una coma delante de ${quoted(second)}."

    override fun textAsValue(text: String) = "Un texto como $text solo se puede mostrar, con \"show\"."
}
