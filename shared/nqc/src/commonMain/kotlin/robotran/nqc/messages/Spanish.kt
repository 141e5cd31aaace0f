package robotran.nqc.messages

import robotran.language.Language
import robotran.language.pasted.PastedCharacter
import robotran.language.quoted
import robotran.nqc.config.ParameterLimit

/**
 * The messages in Spanish. They address the pupil as "tú". Each term has one translation: array - array,
 * block - bloque, brace - llave, brick - ladrillo, bracket - paréntesis, condition - condición, declare - declarar,
 * function - función, label - etiqueta, loop - bucle, pointer - puntero, semicolon - punto y coma, sub - subrutina,
 * task - tarea, variable - variable. Words of NQC are not translated.
 */
object SpanishNqcMessages :
    NqcMessages,
    DirectiveMessages by SpanishDirectiveMessages,
    NqcSyntaxMessages by SpanishSyntaxMessages,
    NqcNameMessages by SpanishNameMessages,
    NqcCodeMessages by SpanishCodeMessages

private object SpanishDirectiveMessages : DirectiveMessages {
    override fun fileNotFound(name: String) = "En este programa no hay ningún archivo ${quoted(name)}."

    override fun includeNeedsName() = "Tras #include va el nombre de un archivo entre comillas: #include \"mio.nqh\"."

    override fun tooManyIncludes() = "Demasiados archivos se incluyen unos a otros. ¿Se incluye alguno a sí mismo?"

    override fun directiveNeedsName(directive: String) = "Tras #$directive va un nombre, por ejemplo \"VELOCIDAD\"."

    override fun macroRedefined(name: String) =
        "${quoted(name)} ya está definido. Elige otro nombre o escribe antes #undef $name."

    override fun macroParameters(name: String) =
        "Tras ${quoted(name)} va un espacio, o los parámetros entre paréntesis: #define $name(a, b)."

    override fun signInDefinition(sign: String, name: String) = if (sign == ";") {
        "La línea de un #define termina sin punto y coma. Este pasa a cada línea con $name."
    } else {
        "Entre $name y su valor no hay ningún $sign en un #define."
    }

    override fun macroCircular(name: String) =
        "${quoted(name)} se define por sí mismo, así que nunca da un valor. Revisa su #define."

    override fun macroArguments(name: String, count: Int) = when (count) {
        0 -> "${quoted(name)} necesita paréntesis vacíos: $name()."
        1 -> "${quoted(name)} necesita un argumento entre paréntesis: $name(1)."
        else -> "${quoted(name)} necesita $count argumentos entre paréntesis, separados por comas."
    }

    override fun macrosTooLong(name: String) =
        "Las definiciones de ${quoted(name)} hacen el programa demasiado largo. Mete menos unas en otras."

    override fun unterminatedIf() = "Este #if no tiene final. Escribe #endif donde termina."

    override fun elseWithoutIf(directive: String) = "Antes de este #$directive no hay ningún #if."

    override fun unknownDirective(directive: String) = if (directive.isEmpty()) {
        "Tras # va una palabra como \"define\"."
    } else {
        "No existe #$directive. NQC conoce #define, #undef, #include, #if, #ifdef, #else, #endif y #pragma."
    }

    override fun conditionSyntax() =
        "Esta condición no se puede calcular. Puede tener números, nombres, defined(NOMBRE) y operadores."

    override fun conditionIncomplete() = "La condición termina demasiado pronto: falta un número o un nombre."

    override fun conditionBrackets() = "Los paréntesis de esta condición no encajan."

    override fun unterminatedComment() = "Este comentario no tiene final. Escribe */ donde termina."

    override fun errorDirective(text: String) =
        "El propio programa dice que aquí algo está mal: ${text.ifEmpty { "#error" }}"

    override fun warningDirective(text: String) = "El propio programa avisa: ${text.ifEmpty { "#warning" }}"

    override fun unknownPragma(word: String) = if (word.isEmpty()) {
        "Tras #pragma va \"noinit\", \"init\" con una función o \"reserve\" con números."
    } else {
        "NQC no hace caso del #pragma ${quoted(word)}. Conoce noinit, init con una función y reserve con números."
    }

    override fun notReserved(last: Int) =
        "Estas variables no se pueden reservar. Los números van de 0 a $last, y cada uno solo una vez."
}

private object SpanishSyntaxMessages : NqcSyntaxMessages {
    override fun unexpected(text: String) = "${quoted(text)} no encaja aquí. ¿Falta algo antes?"

    override fun unexpectedEnd() = "El programa termina demasiado pronto."

    override fun unknownCharacter(character: String) = "El carácter ${quoted(character)} no significa nada aquí."

    override fun pastedCharacter(pasted: PastedCharacter, written: String) = pasted.adviceIn(Language.SPANISH, written)

    override fun decimalNumber() =
        "El ladrillo solo calcula con números enteros. Cuenta en pasos más pequeños, como décimas o centésimas."

    override fun decimalTime(seconds: String, hundredths: Int) =
        "NQC no tiene decimales y cuenta el tiempo en centésimas de segundo: escribe $hundredths para $seconds segundos."

    override fun misspelledWord(typed: String, meant: String, isCase: Boolean) =
        "${quoted(typed)} no es una palabra de NQC. ¿Querías decir ${quoted(meant)}?" +
            if (isCase) " Las mayúsculas importan." else ""

    override fun otherType(type: String) = "NQC no tiene $type, solo números enteros: int."

    override fun textAsValue() = "El ladrillo no puede mostrar textos, por eso NQC no los tiene. Usa un número."

    override fun quotedName(name: String) = "Escribe $name sin comillas."

    override fun nestedUnit(name: String) =
        "${quoted(name)} no puede estar dentro de una tarea, subrutina o función. Ponlo fuera, antes o después."

    override fun mainFunction(right: String) = "La tarea principal empieza así: $right"

    override fun taskWithBrackets(command: String, task: String) =
        "Después de $command va el nombre de la tarea sin paréntesis: $command $task;"

    override fun taskCommand(written: String, right: String) =
        "${quoted(written)} no es una orden de NQC. Escribe: $right;"

    override fun taskParameters(name: String) =
        "Una tarea no lleva nada entre paréntesis: task $name(). Usa una variable global."

    override fun constantVariable(right: String) = "En NQC solo los parámetros son const. Escribe: $right"

    override fun extraWord(word: String) = "NQC no tiene ${quoted(word)}. Quita esta palabra."

    override fun missingSemicolon() = "Aquí falta un punto y coma."

    override fun missing(sign: String) = "Aquí falta ${quoted(sign)}."

    override fun missingBrace(line: Int) =
        "El bloque que empieza en la línea $line no tiene final. Escribe } donde termina."

    override fun extraBrace() = "Esta } no cierra nada."

    override fun missingValue(before: String) = "Tras ${quoted(before)} falta un valor."

    override fun missingName(before: String, word: String?) = if (word == null) {
        "Tras ${quoted(before)} falta un nombre."
    } else {
        "${quoted(word)} es una palabra de NQC y no puede ser un nombre. Elige otro."
    }

    override fun missingBlock(before: String) = "Tras ${quoted(before)} va un bloque entre llaves: { }."

    override fun missingColon(word: String) = "Faltan los dos puntos de ${quoted(word)}."

    override fun callAsValue(name: String) =
        "${quoted(name)} hace algo, pero no da ningún valor. Escríbelo en su propia línea."

    override fun assignmentAsValue() = "Un = asigna. Para comparar, escribe dos: ==."

    override fun secondChoice() = "Pon la segunda elección con ? entre paréntesis."

    override fun returnWithValue() = "Una función de NQC no da ningún valor. Escribe solo: return;"

    override fun functionWithType(name: String) =
        "Una función de NQC no da ningún valor, por eso empieza con void: void $name(). Puede cambiar variables globales."

    override fun inlineWritten() = "Todas las funciones de NQC ya son inline. Quita esta palabra."

    override fun catchAlone() = "Justo antes de este catch no hay ningún monitor ni acquire con un bloque."

    override fun elseAlone() = "Justo antes de este else no hay ningún if. Dos líneas tras un if necesitan llaves."

    override fun doWithoutWhile() = "Tras el bloque de do va: while (condición);"

    override fun declarationInFor() = "Declara la variable antes del bucle: int i; for (i = 0; i < 3; i++)."

    override fun statementAfterLabel() = "Antes de } falta una orden; basta con un punto y coma."

    override fun outsideTask(text: String) =
        "${quoted(text)} tiene que estar en una tarea, subrutina o función. Un programa empieza con task main()."

    override fun parameterNeedsType(text: String) =
        "Un parámetro empieza con int, const int o __sensor, no con ${quoted(text)}."

    override fun resourceWritten() = "__res es para Spybots; un RCX no tiene nada así."

    override fun sourceTooLong(limit: Int) = "El archivo es demasiado largo. Como máximo, $limit caracteres."

    override fun programTooLong() = "El programa es demasiado largo para un ladrillo."

    override fun nestedTooDeeply(limit: Int) =
        "Aquí hay demasiadas cosas unas dentro de otras. Como máximo, $limit niveles."

    override fun numberTooLarge() = "Este número es demasiado grande. El ladrillo calcula con -32768 a 32767."

    override fun noEffect() = "Esta línea no hace nada. ¿Querías asignar con = o llamar a una función?"

    override fun emptyBody(word: String) =
        "Este punto y coma termina el $word, así que lo que sigue ya no pertenece a él. Quítalo."

    override fun misleadingIndent(word: String) =
        "Esta línea no pertenece al $word: sin llaves solo pertenece una. Pon { } alrededor de las dos."
}

private object SpanishNameMessages : NqcNameMessages {
    override fun mainMissing(suggestion: String?) = if (suggestion == null) {
        "El programa no tiene tarea principal. Empieza con: task main() { }"
    } else {
        "La tarea que inicia el programa tiene que llamarse main, no $suggestion."
    }

    override fun redeclared(name: String, line: Int?) = if (line == null) {
        "${quoted(name)} es un nombre del propio NQC. Elige otro."
    } else {
        "${quoted(name)} ya está declarado en la línea $line. Elige otro nombre."
    }

    override fun undefinedVariable(name: String, suggestion: String?) =
        "No hay ninguna variable ${quoted(name)}. ${didYouMean(suggestion) ?: "Declárala antes: int $name;"}"

    override fun notOfSeries(name: String, others: List<String>) =
        "No hay ningún ${quoted(name)}. Hay: ${others.joinToString()}"

    override fun sensorByName(right: String) = "Un sensor se lee solo con su nombre: $right"

    override fun undefinedCommand(name: String, suggestion: String?) = "No hay nada que se llame ${quoted(name)}. " +
        (didYouMean(suggestion) ?: "Una orden es así: OnFwd(OUT_A);")

    override fun bracketsMissing(name: String, call: String) = "Después de ${quoted(name)} van paréntesis: $call;"

    override fun undefinedFunction(name: String, suggestion: String?) =
        "No hay ninguna función ${quoted(name)}. ${didYouMean(suggestion) ?: "Revisa cómo se escribe."}"

    override fun undefinedTask(name: String, suggestion: String?) =
        "No hay ninguna tarea ${quoted(name)}. ${didYouMean(suggestion) ?: "Escríbela: task $name() { }"}"

    override fun taskCalled(name: String) = "${quoted(name)} es una tarea. Escribe: start $name;"

    override fun needsSecondFirmware(name: String) =
        "${quoted(name)} necesita el firmware 2.0. Este programa es para el firmware 1.0 (destino RCX)."

    override fun taskNeverStarted(name: String) = "Nada inicia la tarea ${quoted(name)}. Escribe: start $name;"

    override fun undefinedLabel(name: String) =
        "Aquí no hay ninguna etiqueta ${quoted(name)}. Tiene que estar en la misma tarea, subrutina o función: $name:"

    override fun labelRedefined(name: String) = "La etiqueta ${quoted(name)} está dos veces. Elige otro nombre."

    override fun initUndefined(name: String) = "#pragma init nombra ${quoted(name)}, pero ninguna función se llama así."

    override fun isArray(name: String) = "${quoted(name)} es un array. Di qué elemento: $name[0]."

    override fun isNotArray(name: String) = "${quoted(name)} no es un array y no tiene elementos. Quita [ ]."

    override fun isNotPointer(name: String) =
        "${quoted(name)} no es un puntero. Decláralo con un asterisco: int *$name;"

    override fun arrayInitialized(name: String) =
        "Un array no recibe un valor al declararlo. Asigna algo a sus elementos: $name[0] = 1;"

    override fun argumentCount(name: String, needed: Int, given: Int, call: String) = when (needed) {
        0 -> "${quoted(name)} no lleva nada entre paréntesis: $name()."
        1 -> "${quoted(name)} lleva un argumento, pero aquí hay $given. Escríbelo así: $call;"
        else -> "${quoted(name)} lleva $needed argumentos, pero aquí hay $given. Escríbelo así: $call;"
    }

    override fun argumentNotConstant() =
        "Esto tiene que ser una constante: un número o un nombre como OUT_A, no una variable."

    override fun argumentNotVariable() = "Esto tiene que ser una variable, porque la función la cambia."

    override fun argumentNotSensor() = "Esto tiene que ser un sensor: SENSOR_1, SENSOR_2 o SENSOR_3."

    override fun argumentNotPointer() = "Esto tiene que ser un puntero, o la dirección de una variable: &nombre."

    override fun nestedSub(name: String) =
        "Una subrutina no puede llamar a otra, y ${quoted(name)} lleva a una. Haz de ella una función: void $name()."

    override fun recursion(name: String) = "${quoted(name)} se llama a sí misma. El ladrillo no puede. Usa un bucle."

    override fun subParameters(target: String) =
        "Una subrutina no lleva nada entre paréntesis en $target. Usa una variable global o una función: void."

    override fun tooManyTasks(limit: Int) = "En el ladrillo caben $limit tareas. Esta sobra."

    override fun tooManySubs(limit: Int) =
        "En el ladrillo caben $limit subrutinas. Esta sobra. Haz funciones de algunas: void."

    override fun pointerUnsupported() =
        "Los punteros necesitan el firmware 2.0. Este programa es para el firmware 1.0 (destino RCX)."

    override fun arrayUnsupported() =
        "Los arrays necesitan el firmware 2.0. Este programa es para el firmware 1.0 (destino RCX)."

    override fun acquireUnsupported() =
        "acquire necesita el firmware 2.0. Este programa es para el firmware 1.0 (destino RCX)."

    override fun monitorUnsupported() =
        "monitor necesita el firmware 2.0. Este programa es para el firmware 1.0 (destino RCX)."

    private fun didYouMean(suggestion: String?) = suggestion?.let { "¿Querías decir ${quoted(it)}?" }
}

private object SpanishCodeMessages : NqcCodeMessages {
    override fun noStorage() =
        "El ladrillo no tiene sitio para esta variable. Tiene 32 para todas las tareas y, con el firmware 2.0, 16 " +
            "más para cada una."

    override fun noStorageInSharedSub() =
        "Varias tareas llaman a esta subrutina. Entonces tiene sitio para 16 variables con el firmware 2.0 y ninguna " +
            "con el 1.0."

    override fun noStorageForSub(name: String) =
        "Las variables de ${quoted(name)} y de esta tarea juntas no caben en el ladrillo. Usa menos."

    override fun noTemporaries() =
        "Al ladrillo no le quedan variables para calcular esto. Usa menos variables o divide la línea."

    override fun constantNeeded() = "Esto tiene que ser una constante: un número, o un nombre al que #define da uno."

    override fun shiftNeedsConstant() = "El número de bits que desplazan << y >> tiene que ser una constante."

    override fun numberOutOfRange(number: Int) =
        "$number es demasiado grande para el ladrillo. Los números van de -32768 a 32767."

    override fun numberCut(number: Int, kept: Int) = "$number es demasiado grande para el ladrillo. Se queda en $kept."

    override fun caseOutOfRange() = "Un case puede ser de -32768 a 32767."

    override fun notAssignable() = "A esto no se le puede asignar nada. A la izquierda de = va una variable."

    override fun notSteppable() = "Solo una variable se puede cambiar con ++ o --. Escribe x = x + 1;."

    override fun wrongSource() = "Esta orden no acepta un valor así. Asígnalo antes a una variable."

    override fun nestedAcquire() = "Un acquire no puede estar dentro de otro. Júntalos en uno: acquire(A | B)."

    override fun nestedMonitor() = "Un monitor no puede estar dentro de otro. Júntalos en uno: monitor(A | B)."

    override fun continueOutsideLoop() = "continue sigue con la próxima vuelta de un bucle, pero aquí no hay ninguno."

    override fun breakOutsideLoop() = "break sale de un bucle o de un switch, pero aquí no hay ninguno."

    override fun caseOutsideSwitch() = "case y default van dentro de un switch."

    override fun duplicateCase(value: Int?) =
        if (value == null) "Este switch ya tiene un default." else "Este switch ya tiene un case $value."

    override fun wrongEventSource() =
        "Los eventos vienen de SENSOR_1 a SENSOR_3, Timer(0) a Timer(3), Counter(0) a Counter(2) o Message()."

    override fun taskNumberUnknown() =
        "Varias tareas llaman a esta subrutina, así que __taskid podría ser cualquiera de ellas."

    override fun addressNotConstant() = "Para & el número del elemento tiene que ser una constante."

    override fun dividedByZero(isError: Boolean, isModulo: Boolean) = when {
        isError -> "Un número no se puede dividir entre 0."
        isModulo -> "Aquí se divide entre 0. El ladrillo omite la división, así que el resultado no tiene sentido."
        else -> "Aquí se divide entre 0. El ladrillo omite entonces la división."
    }

    override fun wrongArraySize(limit: Int) = "Un array tiene de 1 a $limit elementos."

    override fun indexOutside(name: String, last: Int) =
        "${quoted(name)} tiene los elementos 0 a $last. Este pertenece a otra variable."

    override fun codeTooLong(limit: Int) =
        "El código pasa de $limit bytes. Un ladrillo tiene unos 6000. Convierte funciones en subrutinas: sub."

    override fun memoryFull(bytes: Int, limit: Int) =
        "El programa tiene $bytes bytes, pero un ladrillo solo tiene $limit para todos los programas. Convierte " +
            "funciones en subrutinas: sub."

    override fun sensorNotSet(port: Int, call: String) =
        "Nada dice qué hay conectado a la entrada $port. Escribe al principio: $call;"

    override fun argumentRange(limit: ParameterLimit, value: Int) =
        "${nounOf(limit)} va de ${limit.values.first} a ${limit.values.last}, pero aquí hay $value."

    private fun nounOf(limit: ParameterLimit) = when (limit) {
        ParameterLimit.OUTPUTS -> "Una suma de OUT_A, OUT_B y OUT_C"
        ParameterLimit.POWER -> "La potencia"
        ParameterLimit.SOUND -> "El número de un sonido"
        ParameterLimit.FREQUENCY -> "Una frecuencia"
        ParameterLimit.TONE_TIME -> "La duración de un tono"
        ParameterLimit.TIMER -> "El número de un temporizador"
        ParameterLimit.COUNTER -> "El número de un contador"
        ParameterLimit.EVENT -> "El número de un evento"
        ParameterLimit.MESSAGE -> "Un mensaje"
        ParameterLimit.PROGRAM -> "El número de un programa"
        ParameterLimit.PRIORITY -> "Una prioridad"
        ParameterLimit.HOUR -> "Una hora"
        ParameterLimit.MINUTE -> "Un minuto"
        ParameterLimit.SLEEP_TIME -> "El tiempo hasta apagarse"
        ParameterLimit.WAIT -> "Un tiempo de espera"
        ParameterLimit.DISPLAY -> "Una vista de la pantalla"
        ParameterLimit.DECIMALS -> "El número de decimales"
        ParameterLimit.SENSOR_TYPE -> "El tipo de un sensor"
        ParameterLimit.ENTRIES -> "El número de entradas"
    }
}
