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

    override fun otherAssignment(title: String) = "Se entregó para otra tarea: $title."

    override fun noTask() = "Nada dice de qué tarea del curso es. " +
        "Pon el nombre de la tarea en el nombre del archivo o de una carpeta."

    override fun emptyFolder() = "La carpeta está vacía."

    override fun onlyCompiled() = "Solo tiene clases compiladas. Pide los archivos de Java."

    override fun changed() = "El archivo se cambió después de entregarlo, o está dañado."

    override fun worldChanged() =
        "El mundo está cambiado, y la tarea no lo permite. Se ha evaluado en el mundo de la tarea."

    override fun ownWorld() =
        "El mundo está cambiado, y la tarea lo permite. Aun así, se ha evaluado en el mundo de la tarea."

    override fun unchanged() = "Los programas no se han cambiado."

    override fun sameName(count: Int, file: String) = "$count entregas tienen este nombre. Esta viene de $file."

    override fun languageNotAllowed(program: String) = "$program está en un lenguaje que la tarea no permite."

    override fun wordsNotAllowed(words: List<String>) = "Usa palabras que la tarea no permite: ${listed(words, "y")}."

    override fun teachersFile() = "Es tu propio archivo de la tarea."

    override fun isSolution() = "El programa es igual que tu solución."

    override fun otherName(entered: String) = "La entrega dice que es de $entered."

    override fun bestCounts(chosen: String, all: List<String>) =
        "Se han probado ${listed(all, "y")}: cuenta $chosen, ninguno lo hizo mejor."

    override fun chosenInApp(chosen: String, all: List<String>) =
        "De ${listed(all, "y")} cuenta $chosen, elegido en la aplicación."

    override fun besideProject(programs: List<String>) =
        "Cuenta el proyecto. Al lado ${if (programs.size == 1) "está" else "están"} ${listed(programs, "y")}."

    override fun fewerTries(origins: List<String>) = "Cuenta la entrega con más intentos, sin ${listed(origins, "y")}."

    override fun notTried(origins: List<String>) = "Estas son demasiadas y no se han probado: ${listed(origins, "y")}."

    override fun partUnusable(reason: String) = "No cuenta: $reason"

    override fun compiledLeftOut(classes: List<String>) =
        "Cuenta el código fuente, sin lo compilado en ${listed(classes, "y")}."
}
