package robotran.legofirmware.messages

import robotran.language.quoted

internal object AssemblySpanish : AssemblyMessages {
    override fun sourceTooLong(limit: Int) = "Este texto es demasiado largo. Se permiten como máximo $limit caracteres."

    override fun unknownCharacter(text: String) = "El carácter ${quoted(text)} no significa nada aquí."

    override fun unknownCommand(word: String, suggestion: String?) =
        "No hay ninguna orden ${quoted(word)}." + suggestion?.let { " ¿Querías decir ${quoted(it)}?" }.orEmpty()

    override fun missingCommand(text: String) =
        "Una línea empieza con una orden o una etiqueta, no con ${quoted(text)}."

    override fun wrongNumberCount(form: String) = "Los números no son los de la orden. Su forma es ${quoted(form)}."

    override fun missingComma(text: String) = "Falta una coma antes de ${quoted(text)}."

    override fun numberNeeded(text: String, name: String, form: String) = if (text.isEmpty()) {
        "Aquí falta un número (${quoted(name)}). La forma es ${quoted(form)}."
    } else {
        "${quoted(text)} no es un número. La forma es ${quoted(form)}."
    }

    override fun numberOutOfRange(name: String, number: Int, least: Int, greatest: Int) =
        "Aquí está $number (${quoted(name)}). Se permite de $least a $greatest."

    override fun labelNeeded(text: String, form: String) = if (text.isEmpty()) {
        "Aquí falta la etiqueta. La forma es ${quoted(form)}."
    } else {
        "${quoted(text)} no es una etiqueta. La forma es ${quoted(form)}."
    }

    override fun unknownLabel(name: String, suggestion: String?) =
        "No hay ninguna etiqueta ${quoted(name)}." + suggestion?.let { " ¿Querías decir ${quoted(it)}?" }.orEmpty()

    override fun labelElsewhere(name: String) =
        "La etiqueta ${quoted(name)} está en otra tarea o subrutina. Un salto se queda en la suya."

    override fun labelTwice(name: String, firstLine: Int) =
        "La etiqueta ${quoted(name)} ya está en la línea $firstLine."

    override fun tooFar(command: String, target: String, longForm: String?) =
        "${quoted(command)} no llega hasta ${quoted(target)}." +
            longForm?.let { " Usa ${quoted(it)}, que llega más lejos y también hacia atrás." }.orEmpty()

    override fun outsideChunk(text: String) =
        "${quoted(text)} está fuera de una tarea. Empieza con ${quoted("task 0")} y termina con ${quoted("endt")}."

    override fun notClosed(frame: String, end: String) = "A este ${quoted(frame)} le falta ${quoted(end)}."

    override fun wrongEnd(word: String, expected: String?) = if (expected == null) {
        "${quoted(word)} no cierra nada: no hay ninguna tarea ni subrutina abierta."
    } else {
        "${quoted(word)} no va aquí. ${quoted(expected)} cierra lo que está abierto."
    }

    override fun chunkTwice(frame: String, number: Int) = "Ya hay un ${quoted("$frame $number")}."

    override fun codeTooLong(limit: Int) =
        "Esta tarea o subrutina es demasiado larga. Se permiten como máximo $limit bytes."

    override fun newerCommand(command: String) =
        "Solo el firmware 2.0 conoce ${quoted(command)}. El programa es para el firmware 1.0."

    override fun newerSource(source: Int) =
        "Solo el firmware 2.0 conoce la fuente $source. El programa es para el firmware 1.0."

    override fun newerVariable(variable: Int) = "En el firmware 1.0 no hay variable $variable. La última es la 31."

    override fun restrictedSource(command: String, source: Int) =
        "En el firmware 1.0, ${quoted(command)} no admite la fuente $source. Pon primero el valor en una variable."

    override fun unknownSource(source: Int) = "Un RCX no tiene la fuente $source. Su valor es siempre 0."

    override fun requestOnly(command: String) =
        "${quoted(command)} solo funciona por luz infrarroja. En un programa no hace nada."

    override fun noMainTask() = "No hay tarea 0. Por eso el botón Run no inicia nada."
}
