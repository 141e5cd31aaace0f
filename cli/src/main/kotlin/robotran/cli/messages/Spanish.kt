package robotran.cli.messages

import robotran.language.Language
import robotran.language.listed
import robotran.language.withComma
import robotran.simulation.messages.SpanishSimulationMessages

/** The messages in Spanish; a random seed is a "semilla". */
internal object SpanishCommandMessages :
    CommandMessages,
    FileMessages by SpanishFileMessages,
    RunMessages by SpanishRunMessages,
    RobotMessages by SpanishRobotMessages,
    GradeMessages by SpanishGradeMessages,
    TowerMessages by SpanishTowerMessages,
    WebMessages by SpanishWebMessages,
    OutputMessages by SpanishOutputMessages

private object SpanishFileMessages : FileMessages {
    override val language = Language.SPANISH

    override fun noFile(name: String) = "No existe el archivo $name."

    override fun notAllowed(name: String) = "No se ha podido leer $name: no está permitido."

    override fun notText(name: String) = "$name no es un texto."

    override fun notAJar(name: String) = "$name no es un jar, o está dañado."

    override fun unreadable(name: String, why: String) = "No se ha podido leer $name: $why"

    override fun isFolder(name: String) = "$name es una carpeta, no un archivo."

    override fun isDevice(name: String) =
        "$name no es un archivo con un final, sino un dispositivo o una tubería, que no se puede leer."

    override fun fileTooLarge(name: String, bytes: Long) =
        "$name es demasiado grande: puede tener $bytes bytes como mucho."

    override fun noClassFile(name: String) = "En $name no hay ningún archivo de clase."

    override fun sourceCounts(name: String) = "En $name cuentan los archivos de Java y no las clases compiladas."

    override fun tooManyClasses(name: String, limit: Int) =
        "$name tiene demasiadas clases: en un ladrillo caben $limit."

    override fun classFileTooLarge(name: String, bytes: Int) =
        "$name es demasiado grande: un archivo de clase puede tener $bytes bytes como mucho."

    override fun jarTooLarge(name: String, bytes: Int) =
        "$name es demasiado grande: desempaquetado puede tener $bytes bytes como mucho."

    override fun tooManyPrograms(limit: Int, given: Int) = "En un ladrillo caben $limit programas, y estos son $given."

    override fun notAProgram(name: String, endings: List<String>) =
        "$name no es un programa: su nombre no termina en ${listed(endings, "ni")}, y no es una carpeta."

    override fun includesOutside(name: String, line: Int, included: String) =
        "$name:$line: incluye $included, que no está en la carpeta del programa. Copia ese archivo allí."

    override fun leadsOutside(name: String) = "$name es un enlace a un archivo fuera de su carpeta, y no se lee."

    override fun theLink() = "El enlace"

    override fun noProgramIn(name: String, robot: String) = "$name no tiene ningún programa para su robot $robot."

    override fun notRobolang(name: String, ending: String) =
        "$name no es un programa de Robolang: su nombre no termina en $ending."

    override fun notToBeChecked(name: String, endings: List<String>) =
        "$name no se puede comprobar: su nombre no termina en ${listed(endings, "ni")}."

    override fun compiled(name: String) =
        "$name está compilado: un enlace lleva programas tal como se escribieron, .robo o .java."
}

private object SpanishRunMessages : RunMessages {
    override fun noMistakes(name: String) = "$name no tiene errores."

    override fun warning(line: String) = "$line (un aviso)"

    override fun refusedByBrick(reason: String) = "Un ladrillo de verdad rechazaría este programa. $reason"

    override fun imageBuilt(name: String?, bytes: String, left: String): String {
        val sentence =
            name?.let { "$it tiene $bytes bytes." } ?: "El programa ocupa $bytes bytes de la memoria del ladrillo."
        return "$sentence En el ladrillo quedan $left bytes para objetos, arrays y textos."
    }

    override fun firmwareImageBuilt(name: String?, bytes: String, limit: String) =
        name?.let { "$it está escrito. " }.orEmpty() +
            "El programa ocupa $bytes de los $limit bytes que un ladrillo tiene para todos los programas y el " +
            "registro de datos."

    override fun notFormatted(name: String) = "$name no está ordenado."

    override fun notInUtf8(name: String, encoding: String) = "$name está en $encoding y no en UTF-8."

    override fun nowInUtf8(name: String, encoding: String) = "$name estaba en $encoding y ahora está en UTF-8."

    override fun needsDesktopApp() =
        "Para las ventanas y las imágenes hace falta la aplicación de escritorio, que ./robotran construye e inicia."

    override fun projectHasItsOwn() =
        "Un proyecto tiene su mundo y sus programas: --robot va con él solo junto con --world."

    override fun firstRobotNamed(name: String) = "El robot $name es el primero: sus programas se dan sin --robot."

    override fun romLogLacks(calls: Long) =
        "Al registro de la ROM le faltan las primeras $calls llamadas: solo guarda las últimas."

    override fun nothingStrayed() = "Nada ha desviado al robot."

    override fun ended(seconds: String) = "El programa ha terminado a los ${withComma(seconds)} s."

    override fun timeUp(seconds: String) = "Se ha acabado el tiempo a los ${withComma(seconds)} s."

    override fun failed(seconds: String) = "El programa ha fallado a los ${withComma(seconds)} s."

    override fun robotIsAt(x: String, y: String, heading: String, ink: String) =
        "El robot está en x ${withComma(x)} cm, y ${withComma(y)} cm, mirando a ${withComma(heading)} grados; " +
            "ha dibujado ${withComma(ink)} cm."

    override fun goalMet(goal: String) = "${SpanishSimulationMessages.met()}: $goal"

    override fun goalNotMet(goal: String, percent: Int) = "${SpanishSimulationMessages.notMet()} ($percent %): $goal"

    override fun atTime(seconds: String) = "en el segundo ${withComma(seconds)}"

    override fun atPlace(x: String, y: String) = "en x ${withComma(x)} cm, y ${withComma(y)} cm"

    override fun atLine(line: Int) = "en la línea $line"

    override fun atLineOf(file: String, line: Int) = "en la línea $line de $file"
}

private object SpanishGradeMessages : GradeMessages {
    override fun noGoals(world: String) = "El mundo $world no tiene metas, así que no hay nada que calificar."

    override fun noHandIns() = "No hay entregas en lo que se ha indicado."

    override fun pageWithoutPictures() =
        "La página no tiene imágenes: necesitan la aplicación de escritorio, que ./robotran construye e inicia."

    override fun noRobot(name: String) = "Ningún robot de este mundo se llama $name."

    override fun goalColumns() = listOf("meta", "semillas", "peor")

    override fun programColumns() = listOf("programa", "semillas superadas", "primera meta sin conseguir")

    override fun countOf(some: Int, all: Int) = "$some de $all"

    override fun cannotRun() = "No puede ejecutarse: tiene errores."

    override fun cannotBeUsed() = "No se puede usar."

    override fun numberedLink(number: Int) = "enlace $number"

    override fun seeds(first: Int, last: Int) = if (first == last) {
        "la semilla $first"
    } else {
        "las semillas de la $first a la $last"
    }

    override fun meetsAll(program: String, seeds: String) = "$program consigue todas las metas con $seeds."

    override fun meetsSome(program: String, passed: Int, all: Int, seeds: String) =
        "$program consigue todas las metas con $passed de $all semillas ($seeds)."

    override fun seedMissed(seed: Int, goal: String?, percent: String) =
        if (goal == null) "Semilla $seed: ninguna meta" else "Semilla $seed: no se ha conseguido \"$goal\" ($percent)"

    override fun seedFailed(missed: String, error: String) = "$missed. El programa ha fallado: $error"

    override fun noGoal() = "ninguna meta"

    override fun programFailed(error: String) = "El programa ha fallado: $error"

    override fun moreSeeds(count: Int, seeds: String) = "Y $count más: semillas $seeds."

    override fun runsDone(done: Int, all: Int) = "$done de $all pruebas"
}

private object SpanishWebMessages : WebMessages {
    override fun notAnAssignment(name: String) =
        "$name no es una tarea. \"Crear una tarea\" en la aplicación la convierte en una."

    override fun noSuchCourse(name: String, known: List<String>) =
        "No hay ningún curso llamado $name. Están ${listed(known, "y")}."

    override fun isCourse(name: String) = "$name es un curso entero. Elige una de sus tareas."

    override fun siteNotBuilt(folder: String) =
        "En $folder no hay ninguna página construida. La construye ./gradlew :webApp:dist."

    override fun siteNotHere() =
        "Este Robotran no trae la página web. Sirve la de su código fuente con ./robotran web o di una carpeta con " +
            "--site."

    override fun portTaken(port: Int) =
        "El puerto $port no se puede usar, quizá porque lo usa otro programa. Elige otro con --port."

    override fun siteServed(address: String) =
        "Robotran está en $address, solo para esta máquina, hasta que pulses Ctrl+C."

    override fun linksStayHere(site: String) =
        "Los enlaces que empiezan con $site solo funcionan en este ordenador; para otras personas, pon el sitio " +
            "donde puedan llegar."
}
