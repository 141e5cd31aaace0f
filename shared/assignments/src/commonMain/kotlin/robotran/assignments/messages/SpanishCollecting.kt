package robotran.assignments.messages

import robotran.language.listed

internal object SpanishCollectingMessages : CollectingMessages {
    override fun notText(file: String) = "$file no es un texto."

    override fun tooLarge(file: String, bytes: Int) = "$file es demasiado grande: puede tener $bytes bytes como mucho."

    override fun programTooLong(file: String, characters: Int) =
        "$file es demasiado largo: un programa puede tener $characters caracteres como mucho."

    override fun brokenZip(file: String) = "$file está dañado, o no es un archivo zip."

    override fun zip64(file: String) = "$file es un archivo zip de los grandes (zip64), que no se puede leer."

    override fun encrypted(file: String) = "$file tiene contraseña."

    override fun unknownCompression(file: String) = "$file está comprimido de un modo que no se puede leer."

    override fun zipTooDeep(file: String, depth: Int) =
        "$file está dentro de demasiados archivos zip: puede haber $depth uno dentro de otro."

    override fun zipTooLarge(file: String, bytes: Int) =
        "$file se vuelve demasiado grande: descomprimido puede tener $bytes bytes como mucho."

    override fun tooManyEntries(file: String, limit: Int) = "$file tiene demasiados archivos: se pueden leer $limit."

    override fun nothingUsable() = "No contiene ningún programa, ni proyecto, ni enlace."

    override fun noProgram(robot: String) = "No tiene ningún programa para su robot $robot."

    override fun onlyWorld() = "Es un enlace a un mundo, sin programa."

    override fun onlyCourse() = "Es un enlace a un curso, sin programa."

    override fun tooManyPrograms(count: Int, limit: Int) = "Tiene $count programas, pero en un ladrillo caben $limit."

    override fun others() = "Otros"

    override fun leftOut(count: Int, limit: Int) = "Faltan $count más: se pueden ver $limit entregas a la vez."

    override fun linkIn(file: String, line: Int) = "$file, línea $line"

    override fun isAssignment(file: String) = "$file es la tarea misma, no una entrega."

    override fun isFeedback(file: String) = "$file son comentarios, no una entrega."

    override fun pastedLink(number: Int) = "Enlace pegado $number"

    override fun changed() = "El archivo se cambió después de entregarlo, o está dañado."

    override fun otherAssignment(title: String) = "Se entregó para otra tarea: $title."

    override fun worldChanged() =
        "El mundo está cambiado, y la tarea no lo permite. Se ha evaluado en el mundo de la tarea."

    override fun ownWorld() =
        "El mundo está cambiado, y la tarea lo permite. Aun así, se ha evaluado en el mundo de la tarea."

    override fun unchanged() = "Los programas no se han cambiado."

    override fun sameName(count: Int, file: String) = "$count entregas tienen este nombre. Esta viene de $file."

    override fun languageNotAllowed(program: String) = "$program está en un lenguaje que la tarea no permite."

    override fun wordsNotAllowed(words: List<String>) = "Usa palabras que la tarea no permite: ${listed(words, "y")}."

    override fun olderLeftOut(count: Int) = if (count == 1) {
        "Otra entrega de la misma persona no cuenta: es anterior."
    } else {
        "Otras $count entregas de la misma persona no cuentan: son anteriores."
    }
}
